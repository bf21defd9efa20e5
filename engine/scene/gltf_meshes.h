// glTF meshes as triangles in the scene's space.
#pragma once

#include "engine/scene/gltf_accessor.h"
#include "engine/scene/gltf_morphs.h"
#include "engine/scene/raw_scene.h"

#include <memory>

namespace manylight {

/// What deforms a mesh where a node shows it.
struct GltfShape {
    std::shared_ptr<const GltfMorph> morph;                         // none: no target changes it
    std::shared_ptr<const std::vector<glm::dmat4>> sceneFromBound;  // of its skin, by joint; none: it has no skin
};

/// Appends a mesh in one place, or where its joints are: what follows joints knows no other place. `turnsWinding`: the
/// corners the other way round, so that the front stays in front where a transform mirrors.
void addGltfMesh(const GltfFile& gltf, int mesh, const GltfShape& shape, const glm::dmat4& sceneFromNode,
                 bool turnsWinding, RawScene& scene);

}  // namespace manylight
