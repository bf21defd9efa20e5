// Meshes and nodes of a generated scene as glTF 2.0.
#pragma once

#include "engine/core/report.h"
#include "engine/scene/generate/mesh.h"

#include <string>

namespace manylight {

/// A glTF file in the making, with one buffer.
struct GltfText {
    Json json{{"asset", {{"version", "2.0"}, {"generator", "manylight-scenes"}}},
              {"scene", 0},
              {"scenes", {{{"nodes", Json::array()}}}},
              {"nodes", Json::array()},
              {"meshes", Json::array()},
              {"materials", Json::array()},
              {"accessors", Json::array()},
              {"bufferViews", Json::array()}};
    std::string bytes;
};

enum class GltfNumber : int { UnsignedInt = 5125, Float = 5126 };

/// Adds numbers of four bytes each to the buffer, in elements of a `type` such as VEC3. Returns the accessor's index.
size_t addGltfAccessor(GltfText& gltf, const void* numbers, size_t byteCount, size_t elementCount, GltfNumber number,
                       const char* type);

/// Adds a mesh and its materials; faces are flat. Returns its index.
size_t addGltfMesh(GltfText& gltf, const Mesh& mesh, const std::string& name);

/// A node that shows a mesh: scaled, turned about the vertical axis, moved.
void addGltfNode(GltfText& gltf, size_t mesh, const Placement& place, const glm::dvec3& scale);

}  // namespace manylight
