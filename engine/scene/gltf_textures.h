// glTF textures: images, samplers, coordinates and their transforms.
#pragma once

#include "engine/scene/gltf_accessor.h"
#include "engine/scene/raw_scene.h"
#include "engine/scene/texture_file.h"

#include <array>

namespace manylight {

/// Which TEXCOORD sets of the primitives of a material become Vertex::uv and uv1.
using GltfUvSets = std::array<int, 2>;

/// The set a textureInfo uses; KHR_texture_transform may override it.
int gltfUvSet(const Json& textureInfo);

/// uv' = matrix * uv + offset as KHR_texture_transform says: scaled, turned, moved.
struct GltfUvTransform {
    glm::mat2 matrix{1.0f};
    glm::vec2 offset{0.0f};
};
GltfUvTransform gltfUvTransform(const Json& textureInfo);

/// Loads the textures that materials use into a scene.
class GltfTextures {
  public:
    GltfTextures(const GltfFile& gltf, RawScene& scene)
        : gltf_(gltf), warnings_(scene.warnings), textures_(scene.textures, scene.warnings) {}

    /// The textureInfo `owner[key]`, checked before; none if it is not there, cannot be read or uses a third set of
    /// coordinates, which is counted.
    TextureUse read(const Json& owner, const char* key, const GltfUvSets& sets, const std::string& place);

  private:
    int32_t load(size_t texture);
    EncodedImage decode(size_t image) const;

    const GltfFile& gltf_;
    Warnings& warnings_;
    TextureLoader textures_;
};

}  // namespace manylight
