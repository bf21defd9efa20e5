#include "tests/unit/import_gltf_support.h"

#include <gmock/gmock.h>

namespace manylight::testing {
namespace {

using ::testing::HasSubstr;

TEST_F(GltfImport, ReadsEmbeddedExternalAndBinary) {
    const Scene embedded = importJson();
    json_["buffers"][0]["uri"] = "my%20data.bin";
    write("my data.bin", triangleData());
    const Scene external = importJson();
    const Scene binary = import("a.glb", glbBytes());
    for (const Scene* scene : {&embedded, &external, &binary}) {
        ASSERT_EQ(scene->triangles.size(), 1u);
        EXPECT_TRUE(isNear(filePosition(*scene, 0, 1), {1, 0, 0}));
        EXPECT_EQ(cornerOf(*scene, 0, 1).normal, glm::vec3(0, 0, 1));
        EXPECT_EQ(cornerOf(*scene, 0, 2).uv, glm::vec2(0, 1));
        EXPECT_EQ(scene->materials.size(), 1u);
        EXPECT_EQ(scene->materials[0].albedo, glm::vec3(1.0f));
    }
}

TEST_F(GltfImport, AppliesMatricesAndNestedTransforms) {
    json_["nodes"] = Json::parse(R"([{"matrix": [0,2,0,0, -2,0,0,0, 0,0,2,0, 10,20,30,1], "children": [1]},
        {"mesh": 0, "translation": [1, 0, 0], "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [3, 3, 3]}])");
    const Scene scene = importJson();
    EXPECT_TRUE(isNear(filePosition(scene, 0, 0), {10, 22, 30}, 1e-5));
    EXPECT_TRUE(isNear(filePosition(scene, 0, 1), {4, 22, 30}, 1e-5));
    EXPECT_TRUE(isNear(filePosition(scene, 0, 2), {10, 16, 30}, 1e-5));
    EXPECT_TRUE(isNear(cornerOf(scene, 0, 0).normal, {0, 0, 1}));
}

TEST_F(GltfImport, MirroringKeepsFrontAndNormalTogether) {
    for (const auto& scale : {Json{-1, 1, 1}, Json{1, 1, -1}, Json{-2, -3, -1}, Json{2, -1, -1}}) {
        json_["nodes"][0]["scale"] = scale;
        const Scene scene = importJson();
        ASSERT_EQ(scene.triangles.size(), 1u);
        EXPECT_GT(glm::dot(frontOf(scene, 0), glm::dvec3(cornerOf(scene, 0, 0).normal)), 0.0) << scale;
    }
}

TEST_F(GltfImport, ScenesAndRoots) {
    json_["nodes"] =
        Json::parse(R"([{"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0], "children": [2]}, {"mesh": 0}])");
    json_["scenes"] = Json::parse(R"([{"nodes": [0]}, {"nodes": [1]}])");
    json_["scene"] = 1;
    EXPECT_EQ(importJson().triangles.size(), 2u);
    EXPECT_EQ(importJson().warnings.count("glTF nodes outside the default scene"), 1u);
    json_.erase("scene");
    EXPECT_EQ(importJson().triangles.size(), 1u);
    json_.erase("scenes");
    EXPECT_EQ(importJson().triangles.size(), 3u);
    EXPECT_EQ(importJson().warnings.count("glTF files without a scene: all nodes are shown"), 1u);
}

TEST_F(GltfImport, StripsFansAndListsWithoutIndices) {
    std::string bytes;
    append<float>(bytes, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
    json_["buffers"][0] = {{"byteLength", bytes.size()}, {"uri", dataUri(bytes)}};
    json_["bufferViews"] = Json::parse(R"([{"buffer": 0, "byteLength": 60}])");
    json_["accessors"] = Json::parse(
        R"([{"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3", "min": [0,0,0], "max": [1,2,0]}])");
    json_["meshes"][0]["primitives"][0] = Json::parse(R"({"attributes": {"POSITION": 0}, "mode": 5})");
    const Scene strip = importJson();
    ASSERT_EQ(strip.triangles.size(), 3u);
    for (size_t t = 0; t < 3; ++t) EXPECT_GT(frontOf(strip, t).z, 0.0);
    json_["meshes"][0]["primitives"][0]["mode"] = 6;
    EXPECT_EQ(importJson().triangles.size(), 3u);
    EXPECT_NEAR(totalArea(importJson()), 0.5 + 0.5 + 1.0, 1e-6);
    json_["meshes"][0]["primitives"][0]["mode"] = 4;
    EXPECT_EQ(importJson().triangles.size(), 1u);
    EXPECT_EQ(importJson().warnings.count("primitives with an incomplete triangle"), 1u);
    json_["meshes"][0]["primitives"][0]["mode"] = 1;
    EXPECT_EQ(importJson().triangles.size(), 0u);
    EXPECT_EQ(importJson().warnings.count("point and line primitives dropped"), 1u);
}

TEST_F(GltfImport, InterleavedNormalisedAndSparseAccessors) {
    std::string bytes;
    append<float>(bytes, {0, 0, 0});
    append<uint16_t>(bytes, {0, 65535});
    append<float>(bytes, {1, 0, 0});
    append<uint16_t>(bytes, {65535, 0});
    append<float>(bytes, {0, 1, 0});
    append<uint16_t>(bytes, {0, 0});
    append<uint8_t>(bytes, {2, 0, 0, 0});
    append<float>(bytes, {0, 7, 0});
    json_["buffers"][0] = {{"byteLength", bytes.size()}, {"uri", dataUri(bytes)}};
    json_["bufferViews"] = Json::parse(R"([{"buffer": 0, "byteLength": 48, "byteStride": 16},
        {"buffer": 0, "byteOffset": 48, "byteLength": 4}, {"buffer": 0, "byteOffset": 52, "byteLength": 12}])");
    json_["accessors"] = Json::parse(R"([
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0,0,0], "max": [1,7,0],
         "sparse": {"count": 1, "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 2}}},
        {"bufferView": 0, "byteOffset": 12, "componentType": 5123, "normalized": true, "count": 3, "type": "VEC2"}])");
    json_["meshes"][0]["primitives"][0] = Json::parse(R"({"attributes": {"POSITION": 0, "TEXCOORD_0": 1}})");
    const Scene scene = importJson();
    EXPECT_TRUE(isNear(filePosition(scene, 0, 2), {0, 7, 0}));
    EXPECT_EQ(cornerOf(scene, 0, 0).uv, glm::vec2(0, 1));
    EXPECT_EQ(cornerOf(scene, 0, 1).uv, glm::vec2(1, 0));
    json_["accessors"][0]["sparse"]["indices"]["componentType"] = 5125;
    EXPECT_TRUE(isNear(filePosition(importJson(), 0, 2), {0, 7, 0}));
    json_["accessors"][0]["sparse"]["indices"]["byteOffset"] = 4;
    EXPECT_THAT(errorOfJson(), HasSubstr("accessors[0].sparse.indices: 1 elements of 4 bytes from byte 4 do not fit"));
    json_["accessors"][0]["sparse"]["indices"] = {{"bufferView", 2}, {"byteOffset", 4}, {"componentType", 5125}};
    EXPECT_THAT(errorOfJson(), HasSubstr("sparse index 1088421888"));  // the bits of 7.0f
}

TEST_F(GltfImport, IndicesOutOfRangeDropTheirTriangle) {
    std::string bytes = triangleData();
    append<uint16_t>(bytes, {0, 1, 3});
    json_["buffers"][0] = {{"byteLength", bytes.size()}, {"uri", dataUri(bytes)}};
    json_["bufferViews"][3]["byteLength"] = 12;
    json_["accessors"][3]["count"] = 6;
    const Scene scene = importJson();
    EXPECT_EQ(scene.triangles.size(), 1u);
    EXPECT_EQ(scene.warnings.count("triangles dropped: vertex index out of range"), 1u);
}

TEST_F(GltfImport, ConesBeyondASphereAreTheSphere) {
    json_["extensions"] = Json::parse(R"({"KHR_lights_punctual": {"lights": [
        {"type": "spot", "intensity": 2, "spot": {"innerConeAngle": 5.2, "outerConeAngle": 5.5}}]}})");
    json_["nodes"] = Json::parse(R"([{"mesh": 0}, {"extensions": {"KHR_lights_punctual": {"light": 0}}}])");
    json_["scenes"][0]["nodes"] = {0, 1};
    const Scene scene = importJson();
    ASSERT_EQ(scene.lights.size(), 1u);
    EXPECT_EQ(scene.lights[0].cosCutoff, -1.0f);
    EXPECT_EQ(scene.lights[0].cosBeam, -1.0f);
    EXPECT_EQ(scene.warnings.count("spot lights shine to all sides: outerConeAngle beyond pi"), 1u);
}

TEST_F(GltfImport, LightsAndCamerasFollowTheirNodes) {
    json_["extensions"] = Json::parse(R"({"KHR_lights_punctual": {"lights": [
        {"type": "point", "intensity": 10, "color": [1, 0.5, 0], "range": 6},
        {"type": "spot", "intensity": 2, "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.4}},
        {"type": "directional", "intensity": 3}]}})");
    json_["cameras"] = Json::parse(R"([{"type": "perspective", "perspective": {"yfov": 0.9, "znear": 0.1}},
        {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 1}}])");
    json_["nodes"] = Json::parse(
        R"([{"mesh": 0}, {"translation": [1, 2, 3], "scale": [9, 9, 9], "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"rotation": [-0.7071067811865476, 0, 0, 0.7071067811865476], "extensions": {"KHR_lights_punctual": {"light": 1}}},
        {"extensions": {"KHR_lights_punctual": {"light": 2}}}, {"translation": [0, 0, 4], "camera": 0}, {"camera": 1}])");
    json_["scenes"][0]["nodes"] = {0, 1, 2, 3, 4, 5};
    const Scene scene = importJson();
    ASSERT_EQ(scene.lights.size(), 3u);
    const float unit = std::ldexp(1.0f, -2 * scene.frame.exponent);
    EXPECT_EQ(scene.lights[0].emission, glm::vec3(10, 5, 0) * unit);
    EXPECT_EQ(scene.lights[0].range, std::ldexp(6.0f, -scene.frame.exponent));  // scales of nodes do not count
    EXPECT_EQ(scene.lights[1].range, std::numeric_limits<float>::infinity());
    EXPECT_TRUE(isNear(scene.lights[1].direction, {0, -1, 0}));
    EXPECT_NEAR(scene.lights[1].cosBeam, std::cos(0.2f), 1e-6f);
    EXPECT_NEAR(scene.lights[1].cosCutoff, std::cos(0.4f), 1e-6f);
    EXPECT_EQ(scene.lights[2].emission, glm::vec3(3.0f));
    EXPECT_TRUE(isNear(scene.lights[2].direction, {0, 0, -1}));
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_FLOAT_EQ(scene.cameras[0].verticalFov, 0.9f);
    EXPECT_EQ(scene.warnings.count("orthographic cameras dropped"), 1u);

    const std::string lights = R"(, "lights": [{"type": "constant", "radiance": [1, 1, 1]}])";
    EXPECT_EQ(import("only.json", R"({"scene": "a.gltf")" + lights + "}").lights.size(), 1u);
    EXPECT_EQ(import("both.json", R"({"scene": "a.gltf", "use_gltf_lights": true)" + lights + "}").lights.size(), 4u);
    EXPECT_EQ(import("theirs.json", R"({"scene": "a.gltf"})").lights.size(), 3u);
}

TEST_F(GltfImport, InstancesAreDrawn) {
    std::string bytes = triangleData() + std::string(2, '\0');
    append<float>(bytes, {0, 0, 0, 5, 0, 0});
    json_["buffers"][0] = {{"byteLength", bytes.size()}, {"uri", dataUri(bytes)}};
    json_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 104}, {"byteLength", 24}});
    json_["accessors"].push_back({{"bufferView", 4}, {"componentType", 5126}, {"count", 2}, {"type", "VEC3"}});
    json_["nodes"][0]["extensions"] = Json::parse(R"({"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 4}}})");
    const Scene scene = importJson();
    ASSERT_EQ(scene.triangles.size(), 2u);
    EXPECT_TRUE(isNear(filePosition(scene, 1, 0), {5, 0, 0}));
}

}  // namespace
}  // namespace manylight::testing
