// Where glTF nodes put what hangs on them.
#pragma once

#include "engine/scene/gltf_accessor.h"
#include "engine/scene/gltf_animation.h"

namespace manylight {

/// The node's matrix, or its parts, of which a pose may replace some.
glm::dmat4 parentFromNode(const tinygltf::Node& node, const NodePose& pose);

/// Whether EXT_mesh_gpu_instancing repeats the node's mesh.
bool hasGltfInstances(const tinygltf::Node& node);

/// Transforms of the node's instances, or the identity alone.
std::vector<glm::dmat4> instancesOf(const GltfFile& gltf, const tinygltf::Node& node);

}  // namespace manylight
