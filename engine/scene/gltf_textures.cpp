#include "engine/scene/gltf_textures.h"

#include "engine/core/error.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

constexpr int kNearest = 9728;
constexpr int kLinear = 9729;
constexpr int kClampToEdge = 33071;
constexpr int kMirroredRepeat = 33648;
constexpr int kRepeat = 10497;

TextureWrap wrapOf(int code, const std::string& place, Warnings& warnings) {
    if (code == kClampToEdge) return TextureWrap::ClampToEdge;
    if (code == kMirroredRepeat) return TextureWrap::MirroredRepeat;
    if (code != kRepeat) warnings.add("texture wraps of unknown kind taken as repeat", place);
    return TextureWrap::Repeat;
}

const Json* transformOf(const Json& textureInfo) {
    if (!textureInfo.contains("extensions")) return nullptr;
    const auto found = textureInfo["extensions"].find("KHR_texture_transform");
    return found == textureInfo["extensions"].end() ? nullptr : &*found;
}

glm::dvec2 pairOr(const Json& object, const char* key, glm::dvec2 fallback) {
    if (!object.contains(key)) return fallback;
    return {object[key][0].get<double>(), object[key][1].get<double>()};
}

}  // namespace

int gltfUvSet(const Json& textureInfo) {
    const Json* const transform = transformOf(textureInfo);
    return transform && transform->contains("texCoord") ? (*transform)["texCoord"].get<int>()
                                                        : textureInfo.value("texCoord", 0);
}

GltfUvTransform gltfUvTransform(const Json& textureInfo) {
    const Json* const transform = transformOf(textureInfo);
    if (!transform) return {};
    const glm::dvec2 scale = pairOr(*transform, "scale", glm::dvec2(1.0));
    const double angle = transform->value("rotation", 0.0);
    // Counter-clockwise about the origin in a frame whose v grows downwards.
    const glm::dmat2 matrix = {{std::cos(angle) * scale.x, -std::sin(angle) * scale.x},
                               {std::sin(angle) * scale.y, std::cos(angle) * scale.y}};
    return {.matrix = glm::mat2(matrix), .offset = glm::vec2(pairOr(*transform, "offset", glm::dvec2(0.0)))};
}

TextureUse GltfTextures::read(const Json& owner, const char* key, const GltfUvSets& sets, const std::string& place) {
    if (!owner.contains(key)) return {};
    const Json& info = owner[key];
    const auto slot = std::find(sets.begin(), sets.end(), gltfUvSet(info));
    if (slot == sets.end()) {
        warnings_.add("textures left out: a third set of coordinates in one material",
                      fmt::format("{}.{}", place, key));
        return {};
    }
    const GltfUvTransform transform = gltfUvTransform(info);
    return {.texture = load(info["index"].get<size_t>()),
            .uvSet = static_cast<uint32_t>(slot - sets.begin()),
            .uvMatrix = transform.matrix,
            .uvOffset = transform.offset};
}

int32_t GltfTextures::load(size_t index) {
    const Json& json = gltf_.container.json;
    const Json& texture = json["textures"][index];
    const std::string place = fmt::format("textures[{}]", index);
    if (!texture.contains("source")) {
        warnings_.add("textures left out: no image of a known kind", place);
        return kNoTexture;
    }
    const auto source = texture["source"].get<size_t>();
    Texture sampling;
    sampling.name = fmt::format("images[{}]", source);
    sampling.isMipmapped = true;
    if (texture.contains("sampler")) {
        const Json& sampler = json["samplers"][texture["sampler"].get<size_t>()];
        sampling.wrapU = wrapOf(sampler.value("wrapS", kRepeat), place, warnings_);
        sampling.wrapV = wrapOf(sampler.value("wrapT", kRepeat), place, warnings_);
        if (sampler.value("magFilter", 0) == kNearest) sampling.filter = TextureFilter::Nearest;
        const int minFilter = sampler.value("minFilter", 0);
        sampling.isMipmapped = minFilter != kNearest && minFilter != kLinear;
    }
    return textures_.load(sampling, [&] { return decode(source); });
}

EncodedImage GltfTextures::decode(size_t index) const {
    const Json& image = gltf_.container.json["images"][index];
    const std::string name = fmt::format("{}: images[{}]", gltf_.container.file, index);
    if (image.contains("bufferView")) {
        const auto [bytes, size] = gltfViewBytes(gltf_, image["bufferView"].get<int>());
        return readImage8(bytes, size, name);
    }
    if (!image.contains("uri")) fail("{}: has neither a uri nor a bufferView", name);
    const std::vector<uint8_t> bytes = readGltfUri(gltf_.container, image["uri"].get<std::string>());
    return readImage8(bytes.data(), bytes.size(), name);
}

}  // namespace manylight
