#include "engine/scene/obj_textures.h"

#include "engine/core/error.h"
#include "engine/scene/derived_texture.h"
#include "engine/scene/text_lines.h"

#include <algorithm>

namespace manylight {
namespace {

namespace fs = std::filesystem;

constexpr double kWhiteHeight = 0.01;  // of the larger side; MTL names no unit of height

Texture samplingOf(const fs::path& folder, const MtlMap& map) {
    Texture sampling;
    sampling.isMipmapped = true;
    sampling.name = (folder / portablePath(map.file)).lexically_normal().string();
    if (map.isClamped) sampling.wrapU = sampling.wrapV = TextureWrap::ClampToEdge;
    return sampling;
}

/// MTL's v grows upwards, a scene's downwards: v' = s v + o becomes 1 - v' = s (1 - v) + (1 - s - o).
TextureUse useOf(int32_t texture, const MtlMap& map) {
    TextureUse use;
    use.texture = texture;
    use.uvMatrix = glm::mat2(glm::dmat2(map.scale.x, 0.0, 0.0, map.scale.y));
    use.uvOffset = glm::vec2(glm::dvec2(map.offset.x, 1.0 - map.scale.y - map.offset.y));
    return use;
}

}  // namespace

fs::path portablePath(std::string_view text) {
    std::string path(trimmed(text));
    if (path.size() > 1 && path.front() == '"' && path.back() == '"') path = path.substr(1, path.size() - 2);
    std::replace(path.begin(), path.end(), '\\', '/');
    return path;
}

TextureUse ObjTextures::colour(const fs::path& folder, const MtlMap& map) {
    const fs::path path = folder / portablePath(map.file);
    return useOf(textures_.load(samplingOf(folder, map), [&] { return readImage8(path); }), map);
}

std::optional<EncodedImage> ObjTextures::decode(const fs::path& folder, const MtlMap& map) {
    return textures_.decode([&] { return readImage8(folder / portablePath(map.file)); });
}

ObjTextures::Coverage ObjTextures::coverage(const fs::path& folder, const MtlMap& map) {
    const std::string key = fmt::format("{}|coverage|{}|{}", samplingOf(folder, map).name, map.channel, map.isClamped);
    const auto [found, isNew] = images_.try_emplace(key);
    if (isNew) found->second = loadCoverage(folder, map);
    return {.use = useOf(found->second.texture, map), .isCutout = found->second.isCutout};
}

ObjTextures::Image ObjTextures::loadCoverage(const fs::path& folder, const MtlMap& map) {
    std::optional<EncodedImage> image = decode(folder, map);
    if (!image) return {};
    Texture texture = samplingOf(folder, map);
    const bool isAsStored = hasAlpha(*image);
    if (!isAsStored) {
        image = coverageImage(*image, map.channel);
        texture.name += fmt::format(" ({} as alpha)", map.channel);
    }
    const bool isCutoutImage = isCutout(*image);
    return {.texture = textures_.load(texture, [&] { return std::move(*image); }),
            .isAsStored = isAsStored,
            .isCutout = isCutoutImage};
}

ObjTextures::Normals ObjTextures::bump(const fs::path& folder, const MtlMap& map) {
    const std::string key =
        fmt::format("{}|bump|{}|{}|{}", samplingOf(folder, map).name, map.channel, map.isClamped, map.bumpMultiplier);
    const auto [found, isNew] = images_.try_emplace(key);
    if (isNew) found->second = loadBump(folder, map);
    const Image& image = found->second;
    return {.use = useOf(image.texture, map), .scale = image.isAsStored ? map.bumpMultiplier : 1.0};
}

ObjTextures::Image ObjTextures::loadBump(const fs::path& folder, const MtlMap& map) {
    std::optional<EncodedImage> image = decode(folder, map);
    if (!image) return {};
    Texture texture = samplingOf(folder, map);
    const bool isAsStored = looksLikeNormals(*image);
    if (isAsStored) {
        warnings_.add("bump maps that hold normals taken as normal maps", texture.name);
    } else {
        const double whiteHeight = kWhiteHeight * std::max(image->width, image->height) * map.bumpMultiplier;
        image = normalsOfHeights(*image, map.channel, whiteHeight, texture);
        texture.name += fmt::format(" (normals of {} times {})", map.channel, map.bumpMultiplier);
    }
    return {.texture = textures_.load(texture, [&] { return std::move(*image); }), .isAsStored = isAsStored};
}

}  // namespace manylight
