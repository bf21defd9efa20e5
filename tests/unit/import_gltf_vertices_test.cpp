#include "tests/unit/import_gltf_support.h"

#include <gmock/gmock.h>

#include <limits>

namespace manylight::testing {
namespace {

using ::testing::HasSubstr;

constexpr int kUnsignedByte = 5121;
constexpr int kShort = 5122;
constexpr int kUnsignedShort = 5123;
constexpr int kFloat = 5126;

TEST_F(GltfImport, ColoursOfEveryLayout) {
    std::string floats;
    append<float>(floats, {1, 0, 0, 0, 1, 0, 0, 0, 0.5f});
    std::string bytes;
    append<uint8_t>(bytes, {255, 0, 0, 255, 0, 255, 0, 51, 0, 0, 255, 0});
    std::string shorts;
    append<uint16_t>(shorts, {65535, 0, 0, 65535, 0, 65535, 0, 13107, 0, 0, 65535, 0});

    primitive()["attributes"]["COLOR_0"] = addAccessor(floats, kFloat, "VEC3");
    EXPECT_EQ(cornerOf(importJson(), 0, 1).colour, glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(cornerOf(importJson(), 0, 2).colour, glm::vec4(0, 0, 0.5f, 1));
    primitive()["attributes"]["COLOR_0"] = addAccessor(bytes, kUnsignedByte, "VEC4", true);
    EXPECT_EQ(cornerOf(importJson(), 0, 1).colour, glm::vec4(0, 1, 0, 0.2f));
    primitive()["attributes"]["COLOR_0"] = addAccessor(shorts, kUnsignedShort, "VEC4", true);
    EXPECT_EQ(cornerOf(importJson(), 0, 1).colour, glm::vec4(0, 1, 0, 0.2f));
    EXPECT_EQ(cornerOf(importJson(), 0, 2).colour, glm::vec4(0, 0, 1, 0));
}

TEST_F(GltfImport, ColoursOutOfRangeAreCounted) {
    std::string floats;
    append<float>(floats, {2, -1, 0.5f, std::numeric_limits<float>::quiet_NaN(), 1, 1, 0, 0, 0});
    primitive()["attributes"]["COLOR_0"] = addAccessor(floats, kFloat, "VEC3");
    const Scene scene = importJson();
    EXPECT_EQ(cornerOf(scene, 0, 0).colour, glm::vec4(1, 0, 0.5f, 1));
    EXPECT_EQ(cornerOf(scene, 0, 1).colour, glm::vec4(1.0f));
    EXPECT_EQ(scene.warnings.count("vertex colours brought into [0, 1]"), 2u);

    std::string bytes;
    append<uint8_t>(bytes, {255, 0, 0, 0, 255, 0, 0, 0, 255});
    primitive()["attributes"]["COLOR_0"] = addAccessor(bytes, kUnsignedByte, "VEC3");
    EXPECT_EQ(importJson().warnings.count("glTF colours of integers that are not normalised"), 1u);
}

TEST_F(GltfImport, TwoSetsOfTextureCoordinates) {
    std::string second;
    append<float>(second, {5, 5, 6, 5, 5, 6});
    primitive()["attributes"]["TEXCOORD_1"] = addAccessor(second, kFloat, "VEC2");
    setMaterial(
        R"({"normalTexture": {"index": 0, "texCoord": 1}, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})");
    const Scene scene = importJson();
    EXPECT_EQ(scene.materials[0].albedoTexture.uvSet, 0u);
    EXPECT_EQ(scene.materials[0].normalTexture.uvSet, 1u);
    EXPECT_EQ(cornerOf(scene, 0, 1).uv, glm::vec2(1, 0));
    EXPECT_EQ(cornerOf(scene, 0, 1).uv1, glm::vec2(6, 5));
}

TEST_F(GltfImport, AThirdSetTakesTheFreePlace) {
    std::string third;
    append<float>(third, {7, 7, 8, 7, 7, 8});
    const size_t accessor = addAccessor(third, kFloat, "VEC2");
    for (const char* name : {"TEXCOORD_1", "TEXCOORD_2"}) primitive()["attributes"][name] = accessor;
    setMaterial(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 2}},
                    "normalTexture": {"index": 0, "texCoord": 0}})");
    const Scene scene = importJson();
    EXPECT_EQ(scene.materials[0].normalTexture.uvSet, 0u);
    EXPECT_EQ(scene.materials[0].albedoTexture.uvSet, 1u);
    EXPECT_EQ(cornerOf(scene, 0, 1).uv, glm::vec2(1, 0));
    EXPECT_EQ(cornerOf(scene, 0, 1).uv1, glm::vec2(8, 7));

    json_["materials"][0]["emissiveFactor"] = {1, 1, 1};
    json_["materials"][0]["emissiveTexture"] = {{"index", 0}, {"texCoord", 1}};
    const Scene crowded = importJson();
    EXPECT_TRUE(crowded.materials[0].albedoTexture.exists());
    EXPECT_TRUE(crowded.materials[0].emissionTexture.exists());
    EXPECT_FALSE(crowded.materials[0].normalTexture.exists());
    EXPECT_EQ(crowded.warnings.entries().at("textures left out: a third set of coordinates in one material").examples,
              std::vector<std::string>{"materials[0].normalTexture"});
}

TEST_F(GltfImport, QuantisedMeshes) {
    std::string positions;
    append<int16_t>(positions, {0, 0, 0, 0, -100, 0, 0, 0, 0, 50, 0, 0});  // padded to eight bytes
    std::string uvs;
    append<uint16_t>(uvs, {0, 0, 65535, 0, 0, 65535});
    primitive()["attributes"] = {{"POSITION", addAccessor(positions, kShort, "VEC3")},
                                 {"TEXCOORD_0", addAccessor(uvs, kUnsignedShort, "VEC2", true)}};
    json_["bufferViews"][4]["byteStride"] = 8;
    json_["nodes"][0]["scale"] = {0.5, 0.5, 0.5};
    json_["extensionsUsed"] = json_["extensionsRequired"] = {"KHR_mesh_quantization"};
    const Scene scene = importJson();
    ASSERT_EQ(scene.triangles.size(), 1u);
    EXPECT_TRUE(isNear(filePosition(scene, 0, 1), {-50, 0, 0}, 1e-4));
    EXPECT_TRUE(isNear(filePosition(scene, 0, 2), {0, 25, 0}, 1e-4));
    EXPECT_EQ(cornerOf(scene, 0, 2).uv, glm::vec2(0, 1));
}

TEST_F(GltfImport, TangentsAreNotMissed) {
    std::string tangents;
    append<float>(tangents, {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
    primitive()["attributes"]["TANGENT"] = addAccessor(tangents, kFloat, "VEC4");
    const Warnings warnings = importJson().warnings;
    EXPECT_EQ(warnings.total(), 2u) << warnings.toText();  // no camera, no light
}

TEST_F(GltfImport, CopiesBeyondAllReasonAreRefused) {
    // Eight million vertices or more, from a file of two kilobytes.
    json_["accessors"].push_back({{"componentType", kFloat}, {"count", 1 << 20}, {"type", "VEC3"}});
    for (const int count : {8, 1 << 20}) {
        json_["accessors"][0]["count"] = count;
        json_["accessors"][0].erase("bufferView");
        primitive() = Json::parse(R"({"attributes": {"POSITION": 0}})");
        json_["nodes"][0]["extensions"] =
            Json::parse(R"({"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 4}}})");
        EXPECT_THAT(errorOfJson(), HasSubstr("which is too many for a file of"));
    }
}

}  // namespace
}  // namespace manylight::testing
