// Image files through OpenImageIO.
#pragma once

#include <cstdint>
#include <filesystem>

#include "wavefront/columns.h"

namespace ctpbench {

// Throws Error(output) if this program cannot write such a file; to be asked before the work is done.
void require_image_output(const std::filesystem::path& path);

// The image row by row from the top. An EXR file gets the linear values themselves, any other kind gets them
// times `exposure`, in sRGB. Throws Error(output).
void write_image(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                 const ImageStorage& image, float exposure);

}  // namespace ctpbench
