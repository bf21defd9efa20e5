// glTF morph targets: differences that are added to the attributes of a mesh.
#pragma once

#include "engine/scene/gltf_accessor.h"

#include <span>
#include <vector>

namespace manylight {

/// The targets that change a mesh, in order: those whose weight is not zero.
struct GltfMorphWeight {
    size_t target = 0;
    double weight = 0.0;

    auto operator<=>(const GltfMorphWeight&) const = default;
};
using GltfMorph = std::vector<GltfMorphWeight>;

/// Targets of a mesh: the most that one of its primitives has.
size_t gltfTargetCount(const tinygltf::Mesh& mesh);

/// `weights` by target; those that are missing are zero, those beyond the mesh's targets change nothing.
GltfMorph gltfMorph(const tinygltf::Mesh& mesh, std::span<const double> weights);

/// Adds the targets' differences to `numbers`, the attribute `name` of the primitive. Colours stay within [0, 1].
void addMorphTargets(const GltfFile& gltf, const tinygltf::Primitive& primitive, const std::string& name,
                     const GltfMorph& morph, std::vector<double>& numbers);

}  // namespace manylight
