#include "report/image.h"

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

void require_image_output(const std::filesystem::path& path) {
    if (!OIIO::ImageOutput::create(path.string()))
        cannot_write(path, OIIO::geterror() + "; use a name that ends in .png");
}

void write_image(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                 const std::vector<float>& rgb) {
    const auto out = OIIO::ImageOutput::create(path.string());
    if (!out) cannot_write(path, OIIO::geterror());
    const OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), 3, OIIO::TypeDesc::UINT8);
    if (!out->open(path.string(), spec) || !out->write_image(OIIO::TypeDesc::FLOAT, rgb.data()) ||
        !out->close())
        cannot_write(path, out->geterror());
}

#else

void require_image_output(const std::filesystem::path& path) {
    cannot_write(path,
                 "this program was built without OpenImageIO; install libopenimageio-dev and build again");
}

void write_image(const std::filesystem::path& path, std::uint32_t, std::uint32_t, const std::vector<float>&) {
    require_image_output(path);
}

#endif

}  // namespace ctpbench
