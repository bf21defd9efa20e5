#include "engine/passes/pack_materials.h"

#include "engine/scene/emitters.h"
#include "engine/scene/mipmaps.h"

#include <map>

namespace manylight {
namespace {

enum class Encoding : uint8_t { Srgb, Linear };

// Of what the camera sees; whether something is there is looked up in the texture itself.
enum class Reduced : uint8_t { No, Yes, ByOpacity };

Averaging averagingOf(Encoding encoding, Reduced reduced) {
    if (encoding == Encoding::Linear) return Averaging::Numbers;
    return reduced == Reduced::ByOpacity ? Averaging::ColoursByOpacity : Averaging::Colours;
}

uint32_t modeOf(const Texture& texture, const TextureUse& use, Encoding encoding) {
    uint32_t mode = texture.filter == TextureFilter::Nearest ? shared::kTextureNearest : 0u;
    if (texture.wrapU == TextureWrap::ClampToEdge) mode |= shared::kTextureClampU;
    if (texture.wrapU == TextureWrap::MirroredRepeat) mode |= shared::kTextureMirrorU;
    if (texture.wrapV == TextureWrap::ClampToEdge) mode |= shared::kTextureClampV;
    if (texture.wrapV == TextureWrap::MirroredRepeat) mode |= shared::kTextureMirrorV;
    if (encoding == Encoding::Linear) mode |= shared::kTextureLinear;
    if (use.uvSet > 0) mode |= shared::kTextureUv1;
    return mode;
}

class TexturePacker {
  public:
    TexturePacker(const Scene& scene, const ScenePlan& plan, PackedMaterials& packed)
        : scene_(scene), isTextured_(plan.textured), isMipmapped_(plan.mipmapped), packed_(packed) {}

    uint32_t pack(const TextureUse& use, Encoding encoding, Reduced reduced) {
        if (!isTextured_ || !use.exists()) return shared::kNoTexture;
        const Texture& texture = scene_.textures[static_cast<size_t>(use.texture)];
        const bool isReduced = isMipmapped_ && texture.isMipmapped && reduced != Reduced::No;
        const uint32_t firstTexel = firstTexelOf(use.texture);
        packed_.textureInfos.push_back(
            {.firstTexel = firstTexel,
             .width = texture.width,
             .height = texture.height,
             .mode = modeOf(texture, use, encoding),
             .uvMatrix = {use.uvMatrix[0].x, use.uvMatrix[0].y, use.uvMatrix[1].x, use.uvMatrix[1].y},
             .uvOffset = use.uvOffset,
             .firstReduced = isReduced ? firstReducedOf(use.texture, averagingOf(encoding, reduced)) : 0u,
             .levelCount = isReduced ? levelsOf(texture.width, texture.height) : 1u});
        return static_cast<uint32_t>(packed_.textureInfos.size() - 1);
    }

  private:
    uint32_t firstTexelOf(int32_t texture) {
        const auto [place, isNew] = firstTexels_.try_emplace(texture, texelCount());
        if (isNew) append(scene_.textures[static_cast<size_t>(texture)].rgba);
        return place->second;
    }

    uint32_t firstReducedOf(int32_t texture, Averaging averaging) {
        const auto [place, isNew] = firstReduced_.try_emplace({texture, averaging}, texelCount());
        if (isNew) append(reducedTexels(scene_.textures[static_cast<size_t>(texture)], averaging));
        return place->second;
    }

    uint32_t texelCount() const { return static_cast<uint32_t>(packed_.texels.size() / 4); }
    void append(const std::vector<uint8_t>& rgba) {
        packed_.texels.insert(packed_.texels.end(), rgba.begin(), rgba.end());
    }

    const Scene& scene_;
    bool isTextured_;
    bool isMipmapped_;
    PackedMaterials& packed_;
    std::map<int32_t, uint32_t> firstTexels_;
    std::map<std::pair<int32_t, Averaging>, uint32_t> firstReduced_;
};

uint32_t alphaModeOf(AlphaMode mode) {
    switch (mode) {
        case AlphaMode::Mask:
            return shared::kAlphaMask;
        case AlphaMode::Blend:
            return shared::kAlphaBlend;
        case AlphaMode::Opaque:
            break;
    }
    return shared::kAlphaOpaque;
}

}  // namespace

bool updateEmission(std::vector<shared::Material>& packed, const Scene& scene) {
    bool isChanged = false;
    for (size_t i = 0; i < packed.size(); ++i) {
        const Material& material = scene.materials[i];
        if (packed[i].emittedRadiance == material.emittedRadiance) continue;
        packed[i].emittedRadiance = material.emittedRadiance;
        packed[i].meanEmission = static_cast<float>(meanEmission(scene, material));
        isChanged = true;
    }
    return isChanged;
}

PackedMaterials packMaterials(const Scene& scene, const ScenePlan& plan) {
    PackedMaterials packed;
    TexturePacker textures(scene, plan, packed);
    for (const Material& material : scene.materials)
        packed.materials.push_back({
            .albedo = material.albedo,
            .albedoTexture = textures.pack(material.albedoTexture, Encoding::Srgb,
                                           material.alphaMode == AlphaMode::Opaque ? Reduced::Yes : Reduced::ByOpacity),
            .emittedRadiance = material.emittedRadiance,
            .emissionTexture = textures.pack(material.emissionTexture, Encoding::Srgb, Reduced::Yes),
            .specular = material.specular,
            .metallic = material.metallic,
            .roughness = material.roughness,
            .metallicRoughnessTexture =
                textures.pack(material.metallicRoughnessTexture, Encoding::Linear, Reduced::Yes),
            .normalTexture = textures.pack(material.normalTexture, Encoding::Linear, Reduced::Yes),
            .normalScale = material.normalScale,
            .alphaMode = alphaModeOf(material.alphaMode),
            .opacity = material.opacity,
            .alphaCutoff = material.alphaCutoff,
            .opacityTexture = textures.pack(material.opacityTexture, Encoding::Linear, Reduced::No),
            .meanEmission = static_cast<float>(meanEmission(scene, material)),
            .isUnlit = material.unlit ? 1u : 0u,
            .isCulled = material.culled ? 1u : 0u,
            .unused1 = 0,
        });
    return packed;
}

}  // namespace manylight
