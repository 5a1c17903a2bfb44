#include "run_tables.h"

#include "report/convergence.h"
#include "report/frame_tables.h"
#include "report/growth.h"
#include "report/output_file.h"
#include "report/pareto.h"
#include "report/peers.h"
#include "report/profile.h"
#include "report/summary.h"
#include "report/tables.h"
#include "report/tree_tables.h"
#include "report/type_tables.h"

namespace ctpbench {

void write_tables(const std::filesystem::path& folder, const Config& config, const Results& results,
                  int threads) {
    write_file(folder / "trees.csv", trees_csv(results));
    if (config.measure) write_file(folder / "summary.csv", summary_csv(config, results));
    if (config.study == Study::convergence) {
        write_file(folder / "convergence.csv", convergence_csv(config, results));
        write_file(folder / "convergence_fits.csv", convergence_fits_csv(config, results));
    }
    for (const std::string& table : config.tables) {
        if (table == "table2") {
            write_file(folder / "table2.csv", table2_csv(results));
            write_file(folder / "table2.md", table2_markdown(results));
        }
        if (table == "table3") {
            write_file(folder / "table3.csv", table3_csv(results));
            write_file(folder / "table3.md", table3_markdown(results));
        }
        if (table == "table1") {
            write_file(folder / "table1.csv", table1_csv(results));
            write_file(folder / "table1.md", table1_markdown(results));
        }
        if (table == "narrowing") write_file(folder / "narrowing.csv", narrowing_csv(results));
        if (table == "types") write_file(folder / "types.csv", types_csv(results));
        if (table == "pareto") write_file(folder / "pareto.csv", pareto_csv(config, results));
        if (table == "profile") write_file(folder / "profile.csv", profile_csv(results));
        if (table == "growth") write_file(folder / "growth.csv", growth_csv(results, threads));
        if (table == "peers") write_file(folder / "peers.csv", peers_csv(results, threads));
        if (table == "figure4") write_file(folder / "figure4.csv", figure4_csv(config, results));
    }
}

}  // namespace ctpbench
