// From the images that materials name to textures in the scene's arena.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/notices.h"
#include "scene/scene.h"

namespace ctpbench {

// The images of one material; an empty path is none.
struct TextureFiles {
    std::filesystem::path color, mask;

    bool any() const { return !color.empty() || !mask.empty(); }
    auto operator<=>(const TextureFiles&) const = default;
};

// Gives scene.materials[i] the texture of files[i] if it is used and its type looks at one, which matte and
// plastic do; no other images are read. A mask becomes the texture's alpha; without a colour image the
// texture is white.
//
// Images that cannot be read are noticed, and so is a mesh without texture coordinates; the materials
// concerned keep their plain colour. Throws Error(usage) for images that are too large.
void load_textures(Scene& scene, const std::vector<TextureFiles>& files, Notices& notices);

}  // namespace ctpbench
