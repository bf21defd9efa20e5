// One triangle as glTF, for tests to build on.
#pragma once

#include "tests/unit/import_test_support.h"

namespace manylight::testing {

/// Three positions, three normals, three uvs and three indices of a triangle in the plane z = 0 that faces +z.
inline std::string triangleData() {
    std::string bytes;
    append<float>(bytes, {0, 0, 0, 1, 0, 0, 0, 1, 0});
    append<float>(bytes, {0, 0, 1, 0, 0, 1, 0, 0, 1});
    append<float>(bytes, {0, 0, 1, 0, 0, 1});
    append<uint16_t>(bytes, {0, 1, 2});
    return bytes;
}

inline Json triangleJson() {
    return Json::parse(R"({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2"},
            {"bufferView": 3, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 72, "byteLength": 24}, {"buffer": 0, "byteOffset": 96, "byteLength": 6}],
        "buffers": [{"byteLength": 102}]})");
}

/// Imports that triangle from memory after a test has changed its JSON.
class GltfImport : public SceneFiles {
  protected:
    GltfImport() : json_(triangleJson()) { json_["buffers"][0]["uri"] = dataUri(triangleData()); }

    Scene importJson() const { return import("a.gltf", json_.dump()); }
    std::string errorOfJson() const { return errorOf("a.gltf", json_.dump()); }
    /// An accessor of three elements with a buffer of its own. Returns its index.
    size_t addAccessor(std::string_view bytes, int componentType, const char* type, bool isNormalised = false) {
        json_["buffers"].push_back({{"byteLength", bytes.size()}, {"uri", dataUri(bytes)}});
        json_["bufferViews"].push_back({{"buffer", json_["buffers"].size() - 1}, {"byteLength", bytes.size()}});
        json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                      {"componentType", componentType},
                                      {"normalized", isNormalised},
                                      {"count", 3},
                                      {"type", type}});
        return json_["accessors"].size() - 1;
    }
    Json& primitive() { return json_["meshes"][0]["primitives"][0]; }
    /// Gives the triangle one material and the file one texture (red, green).
    void setMaterial(const char* material) {
        write("red.tga", redGreenTga());
        json_["images"] = Json::parse(R"([{"uri": "red.tga"}])");
        json_["textures"] = Json::parse(R"([{"source": 0}])");
        json_["materials"] = Json::array({Json::parse(material)});
        primitive()["material"] = 0;
    }
    std::string glbBytes() const {
        Json json = json_;
        json["buffers"][0].erase("uri");
        return glb(json.dump(), triangleData());
    }

    Json json_;
};

}  // namespace manylight::testing
