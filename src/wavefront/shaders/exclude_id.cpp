#include "wavefront/cpu_shader.h"

namespace ctpbench {

template std::unique_ptr<Shader> make_with_offset<ExcludeId>(std::string_view, const MaterialTable&);

}  // namespace ctpbench
