#include "engine/scene/diffuse_only.h"

#include <utility>

namespace manylight {
namespace {

Material diffuse(Material&& m) {
    return {.name = std::move(m.name),
            .albedo = m.albedo,
            .albedoTexture = m.albedoTexture,
            .emittedRadiance = m.emittedRadiance,
            .emissionTexture = m.emissionTexture,
            .givenRadiance = m.givenRadiance,
            .emissionScale = m.emissionScale};
}

/// Removes the textures that neither albedo nor emission need, and counts again.
void dropUnusedTextures(Scene& scene) {
    std::vector<int32_t> renumbered(scene.textures.size(), kNoTexture);
    std::vector<Texture> kept;
    const auto keep = [&](TextureUse& use) {
        if (!use.exists()) return;
        int32_t& number = renumbered[static_cast<size_t>(use.texture)];
        if (number == kNoTexture) {
            number = static_cast<int32_t>(kept.size());
            kept.push_back(std::move(scene.textures[static_cast<size_t>(use.texture)]));
        }
        use.texture = number;
    };
    for (Material& material : scene.materials) {
        keep(material.albedoTexture);
        keep(material.emissionTexture);
    }
    scene.textures = std::move(kept);
}

}  // namespace

Scene diffuseOnly(Scene scene) {
    for (Material& material : scene.materials) material = diffuse(std::move(material));
    dropUnusedTextures(scene);
    return scene;
}

}  // namespace manylight
