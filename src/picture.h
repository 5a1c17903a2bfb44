// A quick shaded picture of a scene through its camera, to see that it is what one means to measure.
#pragma once

#include <cstdint>
#include <filesystem>

#include "backends/cpu.h"
#include "scene/scene.h"

namespace ctpbench {

struct PictureSettings {
    std::uint32_t width = 1280, height = 720;
    std::uint32_t samples = 16;  // per pixel
    std::uint64_t seed = 1;
};

// Light comes from the eye and, attenuated by what is near, from everywhere; this is not the path tracer.
// The file's type follows from its name. Throws Error(output), also if built without OpenImageIO.
void draw_scene(CpuBackend& backend, const Scene& scene, const PictureSettings& settings,
                const std::filesystem::path& image);

}  // namespace ctpbench
