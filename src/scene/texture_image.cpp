#include "scene/texture_image.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/memory.h"

#ifdef CTPBENCH_HAS_OPENIMAGEIO
#include <OpenImageIO/imageio.h>
#endif

namespace ctpbench {
namespace {

constexpr std::uint16_t kOne = 65535;
constexpr double kMostPixels = 1 << 28;  // 6 GiB while it is read
constexpr int kMostChannels = 4;

std::uint16_t quantize(float value) {  // NaN: 0
    return value > 0.0f ? static_cast<std::uint16_t>(std::lround(std::min(value, 1.0f) * kOne)) : 0;
}

TextureImage resized(const TextureImage& image, std::uint32_t width, std::uint32_t height) {
    if (image.width == width && image.height == height) return image;
    const Texture texture{0, static_cast<std::uint16_t>(image.width),
                          static_cast<std::uint16_t>(image.height)};
    TextureImage out{width, height, {}};
    out.texels.reserve(std::size_t{width} * height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const Vec2 center{(static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                              (static_cast<float>(y) + 0.5f) / static_cast<float>(height)};
            const TextureSample s = sample_texture(image.texels.data(), texture, center);
            out.texels.push_back(
                {quantize(s.color.x), quantize(s.color.y), quantize(s.color.z), quantize(s.alpha)});
        }
    }
    return out;
}

}  // namespace

TextureImage with_mask(const TextureImage& color, const TextureImage& mask) {
    const std::uint32_t width = std::max(color.width, mask.width);
    const std::uint32_t height = std::max(color.height, mask.height);
    if (double{1} * width * height > kMostPixels)
        throw Error(ExitCode::usage, "a texture of " + std::to_string(color.width) + " x " +
                                         std::to_string(color.height) + " pixels and its mask of " +
                                         std::to_string(mask.width) + " x " + std::to_string(mask.height) +
                                         " have more than 2^28 together; scale them down");
    TextureImage out = resized(color, width, height);
    const TextureImage alpha = resized(mask, width, height);
    for (std::size_t i = 0; i < out.texels.size(); ++i) out.texels[i].a = alpha.texels[i].a;
    return out;
}

#ifdef CTPBENCH_HAS_OPENIMAGEIO

namespace {

// IEC 61966-2-1, from 16 bits to 16 bits: exact for 8-bit values too, which are multiples of 257 here.
std::uint16_t decode_srgb(std::uint16_t encoded) {
    static const std::vector<std::uint16_t> table = [] {
        std::vector<std::uint16_t> values(kOne + 1u);
        for (std::uint32_t i = 0; i <= kOne; ++i) {
            const double v = i / double{kOne};
            const double linear = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
            values[i] = static_cast<std::uint16_t>(std::lround(linear * kOne));
        }
        return values;
    }();
    return table[encoded];
}

struct Pixels {
    std::uint32_t width, height;
    std::size_t channels;
    int alpha;                  // its channel, or -1
    bool srgb;                  // whether colours are encoded
    bool associated;            // whether colours are multiplied by alpha
    std::vector<float> values;  // rows from the bottom up

    std::size_t count() const { return std::size_t{width} * height; }
    const float* at(std::size_t pixel) const { return &values[pixel * channels]; }
    float alpha_of(std::size_t pixel) const { return alpha < 0 ? 1.0f : at(pixel)[alpha]; }
};

std::optional<Pixels> read_pixels(const std::filesystem::path& path, std::string& why) {
    std::error_code code;
    if (!std::filesystem::is_regular_file(path, code)) {
        why = "no such file";
        return std::nullopt;
    }
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    const auto in = OIIO::ImageInput::open(path.string(), &wishes);
    if (!in) {
        why = OIIO::geterror();
        return std::nullopt;
    }
    const OIIO::ImageSpec& spec = in->spec();
    const double count = static_cast<double>(spec.width) * spec.height * std::max(spec.depth, 1);
    const std::string size = path.string() + ": error: the texture has " + std::to_string(spec.width) +
                             " x " + std::to_string(spec.height) + " pixels; ";
    if (spec.width > kOne || spec.height > kOne || spec.depth > 1 || count > kMostPixels)
        throw Error(ExitCode::usage, size + "65535 a side and 2^28 in all are the most, so scale it down");
    // A header may claim anything: more channels than colours and alpha are left where they are.
    const int channels = std::min(spec.nchannels, kMostChannels);
    const int alpha = spec.alpha_channel < channels ? spec.alpha_channel : -1;
    if (count < 1 || channels < 1) {
        why = "it has no pixels";
        return std::nullopt;
    }
    require_memory(count * (channels * sizeof(float) + sizeof(Texel)), path.string(),
                   "scale the texture down");
    Pixels pixels{
        static_cast<std::uint32_t>(spec.width),
        static_cast<std::uint32_t>(spec.height),
        static_cast<std::size_t>(channels),
        alpha,
        !spec.format.is_floating_point() &&
            (spec.format == OIIO::TypeDesc::UINT8 || spec.get_string_attribute("oiio:ColorSpace") == "sRGB"),
        alpha >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0,
        {}};
    pixels.values.resize(pixels.count() * pixels.channels);
    const auto row = static_cast<OIIO::stride_t>(pixels.width * pixels.channels * sizeof(float));
    float* top = pixels.values.data() + (pixels.height - 1) * pixels.width * pixels.channels;
    if (!in->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, top, OIIO::AutoStride, -row)) {
        why = in->geterror();
        return std::nullopt;
    }
    return pixels;
}

}  // namespace

bool can_read_images() { return true; }

std::optional<TextureImage> read_color_image(const std::filesystem::path& path, std::string& why) {
    const std::optional<Pixels> pixels = read_pixels(path, why);
    if (!pixels) return std::nullopt;
    const std::size_t colors = pixels->channels - (pixels->alpha < 0 ? 0 : 1);
    TextureImage image{pixels->width, pixels->height, {}};
    image.texels.reserve(pixels->count());
    for (std::size_t i = 0; i < pixels->count(); ++i) {
        const float* values = pixels->at(i);
        const float alpha = pixels->alpha_of(i);
        const float scale = pixels->associated && alpha > 0.0f ? 1.0f / alpha : 1.0f;
        const auto channel = [&](std::size_t c) {
            const std::uint16_t value = quantize(values[c] * scale);
            return pixels->srgb ? decode_srgb(value) : value;
        };
        const std::uint16_t first = channel(0);
        image.texels.push_back(
            {first, colors < 3 ? first : channel(1), colors < 3 ? first : channel(2), quantize(alpha)});
    }
    return image;
}

std::optional<TextureImage> read_mask_image(const std::filesystem::path& path, std::string& why) {
    const std::optional<Pixels> pixels = read_pixels(path, why);
    if (!pixels) return std::nullopt;
    bool opaque = true;
    for (std::size_t i = 0; i < pixels->count() && opaque; ++i) opaque = pixels->alpha_of(i) >= 1.0f;
    TextureImage image{pixels->width, pixels->height, {}};
    image.texels.reserve(pixels->count());
    for (std::size_t i = 0; i < pixels->count(); ++i)
        image.texels.push_back({kOne, kOne, kOne, quantize(opaque ? pixels->at(i)[0] : pixels->alpha_of(i))});
    return image;
}

#else

bool can_read_images() { return false; }

std::optional<TextureImage> read_color_image(const std::filesystem::path&, std::string& why) {
    why = "this program was built without OpenImageIO";
    return std::nullopt;
}

std::optional<TextureImage> read_mask_image(const std::filesystem::path& path, std::string& why) {
    return read_color_image(path, why);
}

#endif

}  // namespace ctpbench
