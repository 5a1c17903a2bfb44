#include "wavefront/cpu_intersector.h"

namespace ctpbench {

template std::unique_ptr<Intersector> make_with_tests<TypeList<ExcludingTests>>(std::string_view,
                                                                                const LayoutInput&);

}  // namespace ctpbench
