// glTF materials.
#pragma once

#include "engine/scene/gltf_accessor.h"
#include "engine/scene/gltf_textures.h"
#include "engine/scene/raw_scene.h"

namespace manylight {

/// The two sets of texture coordinates that the textures of a material use: 0 and 1 unless they ask for others.
/// Material -1 is the default one.
GltfUvSets gltfUvSets(const GltfFile& gltf, int material);

/// Appends one RawMaterial per glTF material and then the default one, so that material -1 is the last. Metallic and
/// roughness as in glTF 2.0; what is not metal reflects 0.04, or as KHR_materials_ior and KHR_materials_specular say.
void addGltfMaterials(const GltfFile& gltf, RawScene& scene);

}  // namespace manylight
