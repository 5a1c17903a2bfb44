// Image files through OpenImageIO.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace ctpbench {

// Throws Error(output) if this program cannot write such a file; to be asked before the work is done.
void require_image_output(const std::filesystem::path& path);

// RGB, row by row from the top, as it is to be stored. Throws Error(output).
void write_image(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                 const std::vector<float>& rgb);

}  // namespace ctpbench
