// Image files as texels. Colours of 8-bit images and of images tagged as sRGB are decoded; images of floating
// point numbers are linear already. Masks are data, not colours, and are never decoded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kernels/texture.h"

namespace ctpbench {

struct TextureImage {
    std::uint32_t width = 0, height = 0;  // up to 65,535
    std::vector<Texel> texels;            // rows from the bottom up
};

// Whether this program was built with a library that reads images.
bool can_read_images();

// One channel is grey, two are grey and alpha; without alpha the image is opaque. Nothing if the file cannot
// be read; `why` then says so. Throws Error(usage) for an image of more than 65,535 pixels a side, 2^28 in
// all, or more than there is memory for.
std::optional<TextureImage> read_color_image(const std::filesystem::path& path, std::string& why);

// White, its alpha the mask: the image's alpha channel if that is not opaque everywhere, else its first one.
std::optional<TextureImage> read_mask_image(const std::filesystem::path& path, std::string& why);

// `color` with the alpha of `mask`, in the larger of their widths and of their heights. Interpolates as
// rendering does. Throws Error(usage) if these are more than 2^28 texels.
TextureImage with_mask(const TextureImage& color, const TextureImage& mask);

}  // namespace ctpbench
