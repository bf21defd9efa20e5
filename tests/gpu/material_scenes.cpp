#include "tests/gpu/test_scenes.h"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace manylight::test {
namespace {

constexpr uint32_t kTexels = 16;

/// Texels by `texel(x, y)`, in [0, 1].
template <typename Texel>
int32_t addTexture(Scene& scene, const char* name, TextureFilter filter, Texel texel) {
    Texture texture;
    texture.name = name;
    texture.width = texture.height = kTexels;
    texture.filter = filter;
    for (uint32_t y = 0; y < kTexels; ++y)
        for (uint32_t x = 0; x < kTexels; ++x) {
            const glm::vec4 value = texel(static_cast<float>(x) / kTexels, static_cast<float>(y) / kTexels);
            for (int c = 0; c < 4; ++c) texture.rgba.push_back(static_cast<uint8_t>(std::lround(value[c] * 255.0f)));
        }
    scene.textures.push_back(std::move(texture));
    return static_cast<int32_t>(scene.textures.size() - 1);
}

Material& lastMaterial(Scene& scene) { return scene.materials.back(); }

}  // namespace

Scene glossyRoom() {
    Scene scene = sphereInBox();
    const uint32_t metal = addMaterial(scene, {0.9f, 0.7f, 0.4f});
    lastMaterial(scene).metallic = 1.0f;
    lastMaterial(scene).roughness = 0.45f;
    addSphere(scene, {0.2f, -0.3f, -0.2f}, 0.18f, 3, false, true, metal);
    for (const size_t wall : {0u, 4u}) {
        scene.materials[wall].metallic = 1.0f;
        scene.materials[wall].roughness = 0.4f;
    }
    Material& floor = scene.materials[2];  // of -y
    floor.specular = glm::vec3(0.05f);
    floor.roughness = 0.5f;
    return finished(std::move(scene));
}

Scene patternedRoom() {
    Scene scene = sphereInBox();
    const int32_t stripes = addTexture(scene, "stripes", TextureFilter::Nearest, [](float x, float y) {
        return glm::vec4(x < 0.5f ? 1.0f : 0.1f, y < 0.25f ? 1.0f : 0.4f, 0.7f, 1.0f);
    });
    lastMaterial(scene).emissionTexture.texture = stripes;  // the lamp is what sphereInBox() added last
    lastMaterial(scene).emissionTexture.uvMatrix = glm::mat2(0.5f, 0.5f, -0.5f, 0.5f);
    const uint32_t card = addMaterial(scene, {0.2f, 0.9f, 0.5f});
    lastMaterial(scene).unlit = true;
    addQuad(scene, {-0.45f, -0.3f, -0.45f}, {0.3f, 0, 0}, {0, 0.3f, 0}, card);
    for (Vertex& vertex : scene.vertices)
        vertex.colour = {0.5f + vertex.position.x, 0.9f, 0.7f - vertex.position.z, 1.0f};
    for (Vertex& vertex : scene.vertices) vertex.colour = glm::clamp(vertex.colour, 0.0f, 1.0f);
    return finished(std::move(scene));
}

Scene translucentRoom() {
    Scene scene = sphereInBox();
    const uint32_t card = addMaterial(scene, {0.8f, 0.8f, 0.3f});
    lastMaterial(scene).alphaMode = AlphaMode::Blend;
    lastMaterial(scene).opacity = 0.7f;
    addQuad(scene, {-0.4f, 0.1f, -0.4f}, {0.7f, 0, 0}, {0, 0, 0.7f}, card);
    const uint32_t grating = addMaterial(scene, {0.3f, 0.6f, 0.8f});
    lastMaterial(scene).alphaMode = AlphaMode::Mask;
    lastMaterial(scene).opacityTexture.texture = addTexture(scene, "bars", TextureFilter::Nearest, [](float x, float) {
        return glm::vec4(1.0f, 1.0f, 1.0f, std::fmod(x * 4.0f, 1.0f) < 0.5f ? 1.0f : 0.0f);
    });
    addQuad(scene, {-0.1f, -0.5f, -0.05f}, {0.4f, 0, 0}, {0, 0.5f, 0}, grating);
    return finished(std::move(scene));
}

Scene bumpyRoom() {
    Scene scene = sphereInBox();
    const int32_t waves = addTexture(scene, "waves", TextureFilter::Linear, [](float x, float y) {
        const glm::vec3 n = glm::normalize(
            glm::vec3(0.5f * std::sin(x * glm::two_pi<float>()), 0.3f * std::cos(y * glm::two_pi<float>()), 1.0f));
        return glm::vec4(0.5f + 0.5f * n, 1.0f);
    });
    for (size_t wall = 0; wall < 6; ++wall) scene.materials[wall].normalTexture.texture = waves;
    scene.materials[4].specular = glm::vec3(0.04f);
    scene.materials[4].roughness = 0.6f;
    return finished(std::move(scene));
}

}  // namespace manylight::test
