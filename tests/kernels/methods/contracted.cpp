// Compiled with contraction on, see CMakeLists.txt. The kernels' namespace has another name here.
#define ctpbench ctpbench_contracted
#include "kernels/methods/contraction.h"

namespace ctpbench {

// Rays along a plane that hit, then rays at a vertex that Pluecker's and Woop's test miss.
void count_contracted(int (&counts)[3]) {
    const ContractionCounts c = count_contraction();
    counts[0] = c.parallel_hit, counts[1] = c.vertex_missed[0], counts[2] = c.vertex_missed[1];
}

}  // namespace ctpbench
