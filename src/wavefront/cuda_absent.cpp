// Stands in for the CUDA backend in a program that was built without it.
#include "kernels/platform.h"
#include "wavefront/cuda_workload.h"

namespace ctpbench {

// Nobody gets here: use_cuda_device() has refused before.
std::unique_ptr<CudaWorkload> make_cuda_workload(TypedScenes&, std::vector<Batch>&, std::uint32_t) { trap(); }

}  // namespace ctpbench
