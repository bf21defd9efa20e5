#include "tests/unit/import_gltf_support.h"

#include <gmock/gmock.h>

namespace manylight::testing {
namespace {

using ::testing::HasSubstr;

TEST_F(GltfImport, WhatIsNotDrawnIsCounted) {
    json_["extensionsUsed"] = {"VENDOR_something"};
    json_["animations"] = Json::parse("[{}, {}]");
    json_["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 1;
    json_["meshes"][0]["primitives"][0]["attributes"]["COLOR_1"] = 1;
    json_["extensionsUsed"].push_back("KHR_materials_transmission");
    const Warnings warnings = importJson().warnings;
    EXPECT_EQ(warnings.count("glTF extensions ignored"), 2u);
    EXPECT_EQ(warnings.count("animations ignored: nodes keep their rest pose"), 2u);
    EXPECT_EQ(warnings.count("vertex colours beyond the first set ignored"), 1u);
}

TEST_F(GltfImport, BrokenReferencesNameFileAndPath) {
    const std::tuple<const char*, Json, const char*> cases[] = {
        {"/asset/version", "3.0", "a.gltf: asset.version: expected version 2.x"},
        {"/extensionsRequired", Json{"KHR_draco_mesh_compression"}, "a.gltf: extensionsRequired[0]: expected one of"},
        {"/extensionsRequired", Json{"KHR_materials_transmission"}, "found \"KHR_materials_transmission\""},
        {"/scene", 4, "scene: expected an index into scenes (there are 1), found 4"},
        {"/scenes/0/nodes/0", 1, "scenes[0].nodes[0]: expected an integer"},
        {"/nodes/0/mesh", -1, "nodes[0].mesh: expected an index into meshes"},
        {"/nodes/0/children", Json{0}, "nodes[0]: reached twice"},
        {"/nodes/0/matrix", Json{1, 2, 3}, "nodes[0].matrix: expected 16 numbers"},
        {"/meshes/0/primitives/0/indices", 1, "meshes[0].primitives[0].indices: expected an accessor of unsigned"},
        {"/meshes/0/primitives/0/indices", 99, "meshes[0].primitives[0].indices: expected an index into accessors"},
        {"/meshes/0/primitives/0/indices", 4294967299, "meshes[0].primitives[0].indices: expected an index"},
        {"/meshes/0/primitives/0/attributes/POSITION", 2, "POSITION: expected an accessor of VEC3"},
        {"/meshes/0/primitives/0/material", 0, "material: expected an index into materials (there are 0)"},
        {"/accessors/0/count", 4, "accessors[0]: 4 elements of 12 bytes from byte 0 do not fit the 36 bytes"},
        {"/accessors/0/count", 0, "accessors[0].count: expected an integer in [1"},
        {"/accessors/0/byteOffset", 4, "accessors[0]: 3 elements"},
        {"/accessors/0/componentType", 5130, "accessors[0].componentType: expected"},
        {"/accessors/0/bufferView", "a", "accessors[0].bufferView: expected an index into bufferViews"},
        {"/accessors/1/count", 2, "expected an accessor with 3 elements"},
        {"/bufferViews/0/byteStride", 8, "bufferViews[0].byteStride: expected at least the 12 bytes"},
        {"/bufferViews/0/byteLength", 103, "bufferViews[0].byteLength: expected an integer in [1, 102]"},
        {"/bufferViews/0/byteOffset", -4, "bufferViews[0].byteOffset: expected an integer"},
        {"/bufferViews/3/buffer", 1, "bufferViews[3].buffer: expected an index into buffers"},
        {"/buffers/0/byteLength", 200, "buffers[0]: has 102 bytes, expected byteLength 200"},
        {"/buffers/0/uri", "gone.bin", "gone.bin"},
        {"/buffers/0/uri", "http://example.org/a.bin", "no relative path"},
        {"/meshes", 7, "meshes: expected an array"},
        {"/meshes/0/primitives", Json::object(), "meshes[0].primitives: expected an array"},
        {"/materials", Json{{{"doubleSided", 1}}}, "materials[0].doubleSided: expected"},
        {"/materials", Json{{{"emissiveFactor", {1, 2}}}}, "materials[0].emissiveFactor: expected 3 numbers"},
        {"/meshes/0/primitives/0/attributes/COLOR_0", 2, "COLOR_0: expected an accessor of VEC3 or VEC4"},
    };
    for (const auto& [pointer, value, message] : cases) {
        json_ = triangleJson();
        json_["buffers"][0]["uri"] = dataUri(triangleData());
        json_[Json::json_pointer(pointer)] = value;
        EXPECT_THAT(errorOfJson(), HasSubstr(message)) << pointer << " = " << value;
    }
}

TEST_F(GltfImport, EveryTruncationOfAGlbIsRefused) {
    const std::string bytes = glbBytes();
    ASSERT_EQ(import("whole.glb", bytes).triangles.size(), 1u);
    for (size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THAT(errorOf("cut.glb", std::string_view(bytes).substr(0, size)), HasSubstr("cut.glb: ")) << size;
}

TEST_F(GltfImport, EveryTruncationOfAGltfIsRefused) {
    const std::string text = json_.dump();
    for (size_t size = 0; size < text.size(); ++size)
        EXPECT_THAT(errorOf("cut.gltf", std::string_view(text).substr(0, size)), HasSubstr("cut.gltf: not valid JSON"));
}

TEST_F(GltfImport, DamagedBytesNeverCrash) {
    const std::string bytes = glbBytes();
    size_t loaded = 0;
    for (size_t at = 0; at < bytes.size(); ++at) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
        try {
            import("damaged.glb", damaged);
            ++loaded;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("damaged.glb"));
        }
    }
    EXPECT_GT(loaded, 0u);
    EXPECT_LT(loaded, bytes.size());
}

}  // namespace
}  // namespace manylight::testing
