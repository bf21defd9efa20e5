#include "engine/scene/diffuse_only.h"

#include <gtest/gtest.h>

namespace manylight::testing {
namespace {

TEST(DiffuseOnly, KeepsColourAndEmissionAndNothingElse) {
    Scene scene;
    for (const char* name : {"roughness", "albedo", "unused", "emission"}) scene.textures.emplace_back().name = name;
    Material m;
    m.name = "all of it";
    m.albedo = glm::vec3(0.25f);
    m.metallicRoughnessTexture.texture = m.normalTexture.texture = 0;
    m.albedoTexture = {.texture = 1, .uvSet = 1, .uvMatrix = glm::mat2(2.0f), .uvOffset = glm::vec2(0.5f)};
    m.opacityTexture = m.albedoTexture;
    m.emissionTexture.texture = 3;
    m.emittedRadiance = glm::vec3(7.0f);
    m.metallic = 1.0f;
    m.roughness = 0.1f;
    m.specular = glm::vec3(0.04f);
    m.normalScale = 3.0f;
    m.alphaMode = AlphaMode::Blend;
    m.opacity = 0.5f;
    m.unlit = true;
    scene.materials = {m};
    scene.vertices.emplace_back().colour = glm::vec4(0.5f);

    const Scene reduced = diffuseOnly(scene);
    const Material& d = reduced.materials.at(0);
    EXPECT_EQ(d.name, "all of it");
    EXPECT_EQ(d.albedo, glm::vec3(0.25f));
    EXPECT_EQ(d.emittedRadiance, glm::vec3(7.0f));
    EXPECT_EQ(reduced.textures.size(), 2u);
    EXPECT_EQ(reduced.textures.at(static_cast<size_t>(d.albedoTexture.texture)).name, "albedo");
    EXPECT_EQ(reduced.textures.at(static_cast<size_t>(d.emissionTexture.texture)).name, "emission");
    EXPECT_EQ(d.albedoTexture.uvSet, 1u);
    EXPECT_EQ(d.albedoTexture.uvMatrix, glm::mat2(2.0f));
    EXPECT_EQ(d.albedoTexture.uvOffset, glm::vec2(0.5f));
    EXPECT_FALSE(d.metallicRoughnessTexture.exists());
    EXPECT_FALSE(d.normalTexture.exists());
    EXPECT_FALSE(d.opacityTexture.exists());
    EXPECT_EQ(d.metallic, 0.0f);
    EXPECT_EQ(d.specular, glm::vec3(0.0f));
    EXPECT_EQ(d.alphaMode, AlphaMode::Opaque);
    EXPECT_FALSE(d.unlit);
    EXPECT_EQ(reduced.vertices.at(0).colour, glm::vec4(0.5f));
    EXPECT_EQ(diffuseOnly(reduced).textures.size(), 2u);
}

}  // namespace
}  // namespace manylight::testing
