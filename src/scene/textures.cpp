#include "scene/textures.h"

#include <map>
#include <optional>
#include <set>
#include <string>

#include "base/error.h"
#include "base/memory.h"
#include "kernels/materials/list.h"
#include "scene/texture_image.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostTexels = std::uint64_t{1} << 32;  // a texture's place has 32 bits

bool looks_at_textures(const Material& material) { return (kTexturable >> material.look.type & 1u) != 0; }

class TextureLoader {
public:
    explicit TextureLoader(Array<Texel>& arena) : arena_(arena) {}

    // Each pair of files becomes one texture, however many materials share it.
    Texture load(const TextureFiles& files) {
        const auto [known, added] = textures_.try_emplace(files);
        if (added) known->second = append(read(files));
        return known->second;
    }

    void notice_failures(Notices& notices) const {
        if (failed_.empty()) return;
        notices.push_back(
            "texture " + first_failure_ + "; " + std::to_string(failed_.size()) +
            (failed_.size() == 1 ? " image" : " images") +
            " could not be read, and the materials concerned fall back to their plain colour Kd");
    }

private:
    template <class Reader>
    std::optional<TextureImage> read_one(const fs::path& path, const Reader& reader) {
        if (path.empty()) return std::nullopt;
        std::string why;
        std::optional<TextureImage> image = reader(path, why);
        if (image) return image;
        if (failed_.empty()) first_failure_ = path.string() + " (" + why + ")";
        failed_.insert(path);
        return std::nullopt;
    }

    std::optional<TextureImage> read(const TextureFiles& files) {
        std::optional<TextureImage> color = read_one(files.color, read_color_image);
        const std::optional<TextureImage> mask = read_one(files.mask, read_mask_image);
        if (!mask) return color;
        return color ? with_mask(*color, *mask) : mask;
    }

    Texture append(const std::optional<TextureImage>& image) {
        if (!image) return {};
        if (arena_.size() + image->texels.size() > kMostTexels) {
            throw Error(ExitCode::usage,
                        "the scene's textures have more than 2^32 texels together; scale its images down");
        }
        if (arena_.size() + image->texels.size() > arena_.capacity())
            require_memory(2.0 * static_cast<double>(arena_.size() + image->texels.size()) * sizeof(Texel),
                           "the scene's textures", "scale its images down");
        const Texture texture{static_cast<std::uint32_t>(arena_.size()),
                              static_cast<std::uint16_t>(image->width),
                              static_cast<std::uint16_t>(image->height)};
        arena_.insert(arena_.end(), image->texels.begin(), image->texels.end());
        return texture;
    }

    Array<Texel>& arena_;
    std::map<TextureFiles, Texture> textures_;
    std::set<fs::path> failed_;
    std::string first_failure_;
};

std::string counted(std::size_t materials) {
    return std::to_string(materials) + (materials == 1 ? " material names" : " materials name");
}

}  // namespace

void load_textures(Scene& scene, const std::vector<TextureFiles>& files, Notices& notices) {
    const std::vector<bool> used = used_materials(scene);
    std::vector<std::size_t> textured;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (files[i].any() && used[i] && looks_at_textures(scene.materials[i])) textured.push_back(i);
    }
    if (textured.empty()) return;
    if (scene.mesh.texcoords.empty()) {
        notices.push_back(counted(textured.size()) +
                          " textures, but the mesh has no texture coordinates (vt), so they keep their plain "
                          "colour Kd");
    } else if (!can_read_images()) {
        notices.push_back(counted(textured.size()) +
                          " textures, which are left out, since this program was built without OpenImageIO; "
                          "install libopenimageio-dev and build again");
    } else {
        TextureLoader loader(scene.texels);
        for (const std::size_t i : textured) scene.materials[i].look.texture = loader.load(files[i]);
        loader.notice_failures(notices);
    }
}

}  // namespace ctpbench
