// glTF materials and textures.
#pragma once

#include "engine/scene/gltf_accessor.h"
#include "engine/scene/raw_scene.h"

namespace manylight {

/// Which texture coordinates a material's base colour uses, and KHR_texture_transform: uv' = linear * uv + offset.
struct GltfTexcoords {
    int set = 0;
    glm::dmat2 linear{1.0};
    glm::dvec2 offset{0.0};
};

GltfTexcoords gltfTexcoords(const tinygltf::Model& model, int material);

/// Appends one RawMaterial per glTF material and then the default one, so that material -1 is the last.
void addGltfMaterials(const GltfFile& gltf, RawScene& scene);

}  // namespace manylight
