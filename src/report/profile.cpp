#include "report/profile.h"

#include <limits>

#include "report/csv.h"

namespace ctpbench {

std::string profile_csv(const Results& results) {
    const auto ratio = [](std::uint64_t a, std::uint64_t b) {
        return b == 0 ? std::numeric_limits<double>::quiet_NaN()
                      : static_cast<double>(a) / static_cast<double>(b);
    };
    std::string out = csv_line({"scene", "spheres", "bounce", "isa", "rays", "phase", "per_ray",
                                "cycles_each", "cycles_per_ray", "rays_per_loop"});
    for (const ProfileResult& r : results.profiles)
        for (std::uint32_t p = 0; p < kFlightPhases; ++p) {
            const FlightProfile::Phase& phase = r.profile.phases[p];
            out += csv_line(
                {r.workload.scene, std::to_string(r.workload.spheres), std::to_string(r.bounce), r.isa,
                 std::to_string(r.rays), kFlightPhaseNames[p], csv_number(ratio(phase.items, r.rays)),
                 csv_number(ratio(phase.cycles, phase.items)), csv_number(ratio(phase.cycles, r.rays)),
                 csv_number(ratio(phase.items, phase.loops))});
        }
    return out;
}

}  // namespace ctpbench
