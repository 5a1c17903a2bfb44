#include "measure/frame_series.h"

#include <algorithm>
#include <string_view>

namespace ctpbench {

void add_stages(CellResult& cell, const std::vector<StageTime>& stages) {
    std::vector<const char*> kernels;
    for (const StageTime& s : stages) {
        if (std::find(kernels.begin(), kernels.end(), s.kernel) == kernels.end()) kernels.push_back(s.kernel);
    }
    for (const StageTime& s : stages) {
        if (std::string_view(s.kernel) == "shade") cell.shaded += s.rays;
        cell.dropped += s.dropped, cell.clamped += s.clamped;
    }
    for (const char* kernel : kernels) {
        std::uint64_t rays = 0;
        double seconds = 0.0;
        for (const StageTime& s : stages)
            if (s.kernel == kernel) rays += s.rays, seconds += s.seconds;
        cell.add(kernel, rays, static_cast<double>(rays) / seconds * 1e-6, seconds);
    }
}

double seconds_of(const std::vector<StageTime>& stages) {
    double seconds = 0.0;
    for (const StageTime& s : stages) {
        const std::string_view kernel = s.kernel;
        if (kernel != "copy" && !kernel.starts_with("shade_")) seconds += s.seconds;
    }
    return seconds;
}

}  // namespace ctpbench
