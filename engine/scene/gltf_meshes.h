// glTF meshes as triangles in the scene's space.
#pragma once

#include "engine/scene/gltf_accessor.h"
#include "engine/scene/raw_scene.h"

namespace manylight {

/// Appends a mesh in one place. `turnsWinding`: the corners the other way round, so that the front stays in front where
/// a transform mirrors.
void addGltfMesh(const GltfFile& gltf, int mesh, const glm::dmat4& sceneFromNode, bool turnsWinding, RawScene& scene);

}  // namespace manylight
