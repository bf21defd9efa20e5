#include "engine/passes/pack_materials.h"

#include "engine/scene/emitters.h"

#include <map>

namespace manylight {
namespace {

enum class Encoding : uint8_t { Srgb, Linear };

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
        : scene_(scene), isTextured_(plan.textured), packed_(packed) {}

    uint32_t pack(const TextureUse& use, Encoding encoding) {
        if (!isTextured_ || !use.exists()) return shared::kNoTexture;
        const Texture& texture = scene_.textures[static_cast<size_t>(use.texture)];
        packed_.textureInfos.push_back(
            {.firstTexel = firstTexelOf(use.texture),
             .width = texture.width,
             .height = texture.height,
             .mode = modeOf(texture, use, encoding),
             .uvMatrix = {use.uvMatrix[0].x, use.uvMatrix[0].y, use.uvMatrix[1].x, use.uvMatrix[1].y},
             .uvOffset = use.uvOffset,
             .unused = {}});
        return static_cast<uint32_t>(packed_.textureInfos.size() - 1);
    }

  private:
    uint32_t firstTexelOf(int32_t texture) {
        const auto [place, isNew] = firstTexels_.try_emplace(texture, static_cast<uint32_t>(packed_.texels.size() / 4));
        const std::vector<uint8_t>& rgba = scene_.textures[static_cast<size_t>(texture)].rgba;
        if (isNew) packed_.texels.insert(packed_.texels.end(), rgba.begin(), rgba.end());
        return place->second;
    }

    const Scene& scene_;
    bool isTextured_;
    PackedMaterials& packed_;
    std::map<int32_t, uint32_t> firstTexels_;
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

PackedMaterials packMaterials(const Scene& scene, const ScenePlan& plan) {
    PackedMaterials packed;
    TexturePacker textures(scene, plan, packed);
    for (const Material& material : scene.materials)
        packed.materials.push_back({
            .albedo = material.albedo,
            .albedoTexture = textures.pack(material.albedoTexture, Encoding::Srgb),
            .emittedRadiance = material.emittedRadiance,
            .emissionTexture = textures.pack(material.emissionTexture, Encoding::Srgb),
            .specular = material.specular,
            .metallic = material.metallic,
            .roughness = material.roughness,
            .metallicRoughnessTexture = textures.pack(material.metallicRoughnessTexture, Encoding::Linear),
            .normalTexture = textures.pack(material.normalTexture, Encoding::Linear),
            .normalScale = material.normalScale,
            .alphaMode = alphaModeOf(material.alphaMode),
            .opacity = material.opacity,
            .alphaCutoff = material.alphaCutoff,
            .opacityTexture = textures.pack(material.opacityTexture, Encoding::Linear),
            .meanEmission = static_cast<float>(meanEmission(scene, material)),
            .isUnlit = material.unlit ? 1u : 0u,
            .isCulled = material.culled ? 1u : 0u,
            .unused1 = 0,
        });
    return packed;
}

}  // namespace manylight
