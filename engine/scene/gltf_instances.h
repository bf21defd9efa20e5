// What the nodes show of a glTF file's meshes, shared or repeated.
#pragma once

#include "engine/scene/gltf_accessor.h"
#include "engine/scene/gltf_meshes.h"
#include "engine/scene/import_options.h"
#include "engine/scene/raw_scene.h"

#include <vector>

namespace manylight {

/// One mesh at one place.
struct GltfMeshUse {
    int mesh = 0;
    glm::dmat4 sceneFromMesh{1.0};
    std::string place;   // JSON path of the node
    bool moves = false;  // by the animation
    GltfShape shape{};
    bool deforms = false;  // by the animation
};

/// Appends the meshes, in the order of their uses: as triangles in the scene's space, or as shared meshes and instances
/// where chooseSharing() says so: uses that morph targets make equal may share, those with skins never do. What moves
/// is an instance with ImportOptions::keepsMoving. With ImportOptions::placesOnly, RawScene::framePoints hold what
/// deforms.
void addGltfMeshUses(const GltfFile& gltf, const std::vector<GltfMeshUse>& uses, const ImportOptions& options,
                     RawScene& scene);

}  // namespace manylight
