#include "wavefront/cpu_shader.h"

namespace ctpbench {

template std::unique_ptr<Shader> make_with_offset<WaechterBinder>(std::string_view, const MaterialTable&);

}  // namespace ctpbench
