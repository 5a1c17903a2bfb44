#include "wavefront/cpu_intersector.h"

namespace ctpbench {

template std::unique_ptr<Intersector> make_with_bundle<PaperMethods>(std::string_view, const LayoutInput&);

}  // namespace ctpbench
