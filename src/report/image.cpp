#include "report/image.h"

#include <cmath>
#include <vector>

#include "base/error.h"

#ifdef CTPBENCH_HAS_OPENIMAGEIO
#include <OpenImageIO/imageio.h>
#endif

namespace ctpbench {
namespace {

[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& why) {
    throw Error(ExitCode::output, path.string() + ": error: cannot be written: " + why);
}

}  // namespace

#ifdef CTPBENCH_HAS_OPENIMAGEIO
namespace {

float encode_srgb(float linear) {
    const float x = min(max(linear, 0.0f), 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

}  // namespace

void require_image_output(const std::filesystem::path& path) {
    if (!OIIO::ImageOutput::create(path.string()))
        cannot_write(path, OIIO::geterror() + "; use a name that ends in .png or .exr");
}

void write_image(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                 const ImageStorage& image, float exposure) {
    const auto out = OIIO::ImageOutput::create(path.string());
    if (!out) cannot_write(path, OIIO::geterror());
    const bool linear = path.extension() == ".exr";
    std::vector<float> rgb;
    rgb.reserve(image.size() * 3);
    for (std::size_t i = 0; i < image.size(); ++i)
        for (int channel = 0; channel < 3; ++channel) {
            const float value = image.at(i)[channel];
            rgb.push_back(linear ? value : encode_srgb(value * exposure));
        }
    OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), 3,
                         linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
    if (!out->open(path.string(), spec) || !out->write_image(OIIO::TypeDesc::FLOAT, rgb.data()) ||
        !out->close())
        cannot_write(path, out->geterror());
}

#else

void require_image_output(const std::filesystem::path& path) {
    cannot_write(path,
                 "this program was built without OpenImageIO; install libopenimageio-dev and build again");
}

void write_image(const std::filesystem::path& path, std::uint32_t, std::uint32_t, const ImageStorage&,
                 float) {
    require_image_output(path);
}

#endif

}  // namespace ctpbench
