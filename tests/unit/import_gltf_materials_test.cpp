#include "tests/unit/import_gltf_support.h"

#include <gmock/gmock.h>

#include <cmath>

namespace manylight::testing {
namespace {

using ::testing::HasSubstr;

glm::vec2 lookedUpAt(const TextureUse& use, glm::vec2 uv) { return use.uvMatrix * uv + use.uvOffset; }

TEST_F(GltfImport, EveryPartOfAMaterialIsRead) {
    setMaterial(R"({"name": "m", "emissiveFactor": [1, 0.5, 0], "emissiveTexture": {"index": 0},
        "normalTexture": {"index": 0, "scale": 0.5}, "occlusionTexture": {"index": 0}, "doubleSided": true,
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}},
        "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 0.75], "metallicFactor": 0.25, "roughnessFactor": 0.5,
            "baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 0}}})");
    const Scene scene = importJson();
    ASSERT_EQ(scene.materials.size(), 1u);
    const Material& m = scene.materials[0];
    EXPECT_EQ(m.name, "m");
    EXPECT_EQ(m.albedo, glm::vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(m.emittedRadiance, glm::vec3(8, 4, 0));
    EXPECT_EQ(m.metallic, 0.25f);
    EXPECT_EQ(m.roughness, 0.5f);
    EXPECT_EQ(m.specular, glm::vec3(0.04f));
    EXPECT_EQ(m.normalScale, 0.5f);
    EXPECT_EQ(m.alphaMode, AlphaMode::Opaque);
    EXPECT_EQ(m.opacity, 1.0f);
    EXPECT_FALSE(m.opacityTexture.exists());
    EXPECT_FALSE(m.unlit);
    EXPECT_EQ(scene.textures.size(), 1u);
    for (const TextureUse& use : {m.albedoTexture, m.emissionTexture, m.metallicRoughnessTexture, m.normalTexture})
        EXPECT_EQ(use.texture, 0);
    EXPECT_EQ(scene.warnings.total(), 1u) << scene.warnings.toText();  // no camera
}

TEST_F(GltfImport, MaterialsLeftOutOrEmptyAreTheDefault) {
    const Scene none = importJson();
    setMaterial("{}");
    const Scene empty = importJson();
    for (const Scene* scene : {&none, &empty}) {
        ASSERT_EQ(scene->materials.size(), 1u);
        EXPECT_EQ(scene->materials[0].albedo, glm::vec3(1.0f));
        EXPECT_EQ(scene->materials[0].metallic, 1.0f);
        EXPECT_EQ(scene->materials[0].roughness, 1.0f);
        EXPECT_EQ(scene->materials[0].specular, glm::vec3(0.04f));
    }
}

TEST_F(GltfImport, AlphaModes) {
    constexpr const char* kMaterial = R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.75],
        "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"offset": [0.5, 0]}}}}})";
    setMaterial(kMaterial);
    json_["materials"][0]["alphaMode"] = "MASK";
    const Material mask = importJson().materials[0];
    EXPECT_EQ(mask.alphaMode, AlphaMode::Mask);
    EXPECT_EQ(mask.opacity, 0.75f);
    EXPECT_EQ(mask.alphaCutoff, 0.5f);
    EXPECT_EQ(mask.opacityTexture.texture, 0);
    EXPECT_EQ(mask.opacityTexture.uvOffset, glm::vec2(0.5f, 0.0f));
    json_["materials"][0]["alphaCutoff"] = 0.125;
    EXPECT_EQ(importJson().materials[0].alphaCutoff, 0.125f);
    json_["materials"][0]["alphaCutoff"] = 2.0;  // hides everything
    EXPECT_EQ(importJson().materials[0].opacity, 0.0f);
    EXPECT_EQ(importJson().materials[0].alphaCutoff, 1.0f);
    json_["materials"][0]["alphaMode"] = "BLEND";
    EXPECT_EQ(importJson().materials[0].alphaMode, AlphaMode::Blend);
    EXPECT_EQ(importJson().materials[0].opacity, 0.75f);
    json_["materials"][0]["alphaMode"] = "GLASS";
    EXPECT_EQ(importJson().materials[0].alphaMode, AlphaMode::Opaque);
    EXPECT_EQ(importJson().warnings.count("alpha modes of unknown kind taken as opaque"), 1u);
}

TEST_F(GltfImport, UnlitMaterialsKeepOnlyTheirColour) {
    setMaterial(R"({"extensions": {"KHR_materials_unlit": {}}, "emissiveFactor": [1, 1, 1], "alphaMode": "BLEND",
        "normalTexture": {"index": 0},
        "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 0.5], "baseColorTexture": {"index": 0}}})");
    json_["extensionsUsed"] = json_["extensionsRequired"] = {"KHR_materials_unlit"};
    const Scene scene = importJson();
    const Material& m = scene.materials[0];
    EXPECT_TRUE(m.unlit);
    EXPECT_EQ(m.albedo, glm::vec3(0.5f));
    EXPECT_TRUE(m.albedoTexture.exists());
    EXPECT_EQ(m.alphaMode, AlphaMode::Blend);
    EXPECT_EQ(m.specular, glm::vec3(0.0f));
    EXPECT_EQ(m.metallic, 0.0f);
    EXPECT_EQ(m.emittedRadiance, glm::vec3(0.0f));
    EXPECT_FALSE(m.normalTexture.exists());
    EXPECT_EQ(scene.warnings.count("glTF extensions ignored"), 0u);
}

TEST_F(GltfImport, SpecularFollowsIorAndSpecularExtension) {
    const auto specularOf = [&](const char* extensions) {
        setMaterial("{}");
        json_["materials"][0]["extensions"] = Json::parse(extensions);
        return importJson().materials[0].specular;
    };
    EXPECT_EQ(specularOf(R"({"KHR_materials_ior": {"ior": 3}})"), glm::vec3(0.25f));
    EXPECT_EQ(specularOf(R"({"KHR_materials_ior": {"ior": 1}})"), glm::vec3(0.0f));
    EXPECT_EQ(specularOf(R"({"KHR_materials_ior": {"ior": 0}})"), glm::vec3(1.0f));
    EXPECT_EQ(specularOf(R"({"KHR_materials_ior": {}})"), glm::vec3(0.04f));
    EXPECT_EQ(specularOf(R"({"KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [1, 2, 100]}})"),
              glm::vec3(0.02f, 0.04f, 0.5f));
    EXPECT_EQ(specularOf(R"({"KHR_materials_specular": {"specularTexture": {"index": 0}}})"), glm::vec3(0.04f));
    EXPECT_EQ(importJson().warnings.count("textures of KHR_materials_specular left out"), 1u);
}

TEST_F(GltfImport, SamplersAndTextureTransforms) {
    setMaterial(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 7, "extensions":
        {"KHR_texture_transform": {"offset": [0.5, 0.25], "rotation": 1.5707963267948966, "scale": [2, 4],
                                   "texCoord": 0}}}}})");
    json_["textures"][0]["sampler"] = 0;
    json_["samplers"] = Json::parse(R"([{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}])");
    const Scene scene = importJson();
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0].wrapU, TextureWrap::ClampToEdge);
    EXPECT_EQ(scene.textures[0].wrapV, TextureWrap::MirroredRepeat);
    EXPECT_EQ(scene.textures[0].filter, TextureFilter::Nearest);
    EXPECT_TRUE(scene.textures[0].isMipmapped);  // as the sampler says nothing
    const TextureUse& use = scene.materials[0].albedoTexture;
    EXPECT_EQ(use.uvSet, 0u);
    EXPECT_EQ(cornerOf(scene, 0, 1).uv, glm::vec2(1, 0));
    // (1, 0) scaled to (2, 0), turned by 90 degrees to (0, -2), moved.
    EXPECT_LT(glm::length(lookedUpAt(use, {1, 0}) - glm::vec2(0.5f, -1.75f)), 1e-6f);
    // (0, 1) scaled to (0, 4), turned to (4, 0), moved.
    EXPECT_LT(glm::length(lookedUpAt(use, {0, 1}) - glm::vec2(4.5f, 0.25f)), 1e-6f);
    for (const int minFilter : {9728, 9729, 9984, 9985, 9986, 9987}) {
        json_["samplers"][0]["minFilter"] = minFilter;
        EXPECT_EQ(importJson().textures[0].isMipmapped, minFilter >= 9984) << minFilter;
    }
    json_["samplers"][0]["wrapS"] = 12;
    EXPECT_EQ(importJson().warnings.count("texture wraps of unknown kind taken as repeat"), 1u);
}

TEST_F(GltfImport, TexturesThatCannotBeReadAreReplacedByTheFactor) {
    setMaterial(R"({"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0},
        "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1], "baseColorTexture": {"index": 0}}})");
    json_["images"][0]["uri"] = "$(missing).png";
    const Scene scene = importJson();
    EXPECT_FALSE(scene.materials[0].albedoTexture.exists());
    EXPECT_FALSE(scene.materials[0].emissionTexture.exists());
    EXPECT_EQ(scene.materials[0].albedo, glm::vec3(0.5f));
    EXPECT_EQ(scene.materials[0].emittedRadiance, glm::vec3(1.0f));
    EXPECT_EQ(scene.warnings.count("textures left out: image not readable"), 1u);
    json_["images"][0]["uri"] = "red.tga";
    write("red.tga", redGreenTga().substr(0, 20));
    EXPECT_EQ(importJson().warnings.count("textures left out: image not readable"), 1u);
    json_["textures"][0].erase("source");
    EXPECT_EQ(importJson().warnings.count("textures left out: no image of a known kind"), 2u);
}

TEST_F(GltfImport, ValuesOutOfRangeAreBroughtBackAndCounted) {
    setMaterial(R"({"alphaMode": "MASK", "alphaCutoff": -1, "normalTexture": {"index": 0, "scale": 1e300},
        "extensions": {"KHR_materials_specular": {"specularColorFactor": [-1, 1, 1]}},
        "pbrMetallicRoughness": {"metallicFactor": 7, "roughnessFactor": -1, "baseColorFactor": [1, 1, 1, 3],
            "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [1e300, 1]}}}}})");
    const Scene scene = importJson();
    const Material& m = scene.materials[0];
    EXPECT_EQ(m.metallic, 1.0f);
    EXPECT_EQ(m.roughness, 0.0f);
    EXPECT_EQ(m.opacity, 1.0f);
    EXPECT_EQ(m.alphaCutoff, 0.0f);
    EXPECT_EQ(m.specular, glm::vec3(0.0f, 0.04f, 0.04f));
    EXPECT_EQ(m.normalScale, 1.0f);
    EXPECT_EQ(m.albedoTexture.uvMatrix, glm::mat2(1.0f));
    EXPECT_EQ(scene.warnings.count("material values brought into [0, 1]"), 5u);
    EXPECT_EQ(scene.warnings.count("texture transforms removed: not finite"), 2u);  // of albedo and of opacity
    EXPECT_EQ(scene.warnings.count("scales of normal maps set to one: not finite"), 1u);
}

TEST_F(GltfImport, BrokenMaterialsNameTheirPath) {
    const std::pair<const char*, const char*> cases[] = {
        {R"({"normalTexture": {"index": 1}})", "materials[0].normalTexture.index: expected an index into textures"},
        {R"({"normalTexture": {"index": 0, "scale": "big"}})", "materials[0].normalTexture.scale: expected a finite"},
        {R"({"emissiveTexture": {}})", "materials[0].emissiveTexture: missing key \"index\""},
        {R"({"pbrMetallicRoughness": {"metallicFactor": null}})", "pbrMetallicRoughness.metallicFactor: expected"},
        {R"({"pbrMetallicRoughness": {"metallicRoughnessTexture": []}})",
         "metallicRoughnessTexture: expected an object"},
        {R"({"alphaCutoff": []})", "materials[0].alphaCutoff: expected a finite number"},
        {R"({"extensions": {"KHR_materials_ior": {"ior": -2}}})",
         "KHR_materials_ior.ior: expected a number that is not"},
        {R"({"extensions": {"KHR_materials_specular": {"specularColorFactor": [1]}}})", "expected 3 numbers"},
        {R"({"extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": -1}}})",
         "emissiveStrength: expected"},
        {R"({"extensions": 3})", "materials[0].extensions: expected an object"},
    };
    for (const auto& [material, message] : cases) {
        setMaterial(material);
        EXPECT_THAT(errorOfJson(), HasSubstr(message)) << material;
    }
}

}  // namespace
}  // namespace manylight::testing
