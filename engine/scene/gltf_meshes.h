// glTF meshes as triangles in the scene's space.
#pragma once

#include "engine/scene/gltf_accessor.h"
#include "engine/scene/raw_scene.h"

namespace manylight {

/// Appends one instance of a mesh. A transform that mirrors turns the winding round, so that the front stays in front.
void addGltfMesh(const GltfFile& gltf, int mesh, const glm::dmat4& sceneFromNode, RawScene& scene);

}  // namespace manylight
