#include "memory_needs.h"

#include <set>
#include <string>

#include "base/memory.h"

namespace ctpbench {
namespace {

// Bytes that one more adds to the peak of a run, measured on the CPU: of a sphere in the trees and the
// oracle, in the layout of each strategy beside; of a pixel in the rays that are recorded, and in each
// contender's frames.
constexpr double kSphere = 155, kSphereOfLayout = 62;
constexpr double kPixel = 93, kPixelOfFrames = 53;

const char* const kRemedy = "ask for fewer spheres or pixels, or name fewer contenders";

}  // namespace

void require_memory_for(const std::vector<Cell>& cells, const Config& config) {
    for (const WorkloadCells& w : group_by_workload(cells)) {
        std::set<std::string> layouts;
        bool renders = false;
        for (Contender c : w.contenders) {
            renders = renders || c.renders();
            c.shade = no_shade, c.threads = 0;  // these share one
            layouts.insert(c.strategy_name() + "/" + c.traversal + "/" + c.methods + c.types_part() +
                           c.triangle_test + c.sphere_test + c.box_test);
        }
        double bytes = w.workload.spheres * (kSphere + static_cast<double>(layouts.size()) * kSphereOfLayout);
        if (config.measure && config.study != Study::stability)
            bytes += double{1} * config.width * config.height * (kPixel + (renders ? kPixelOfFrames : 0.0));
        require_memory(bytes, w.workload.name(), kRemedy);
    }
}

void require_memory_for_picture(std::uint32_t width, std::uint32_t height, std::uint32_t spheres) {
    require_memory(
        double{1} * width * height * (kPixel + kPixelOfFrames) + spheres * (kSphere + kSphereOfLayout),
        "the picture", kRemedy);
}

}  // namespace ctpbench
