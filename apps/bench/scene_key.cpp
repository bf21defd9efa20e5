#include "apps/bench/scene_key.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <type_traits>

namespace manylight {
namespace {

/// Fields one by one, as structs may have padding.
class Key {
  public:
    template <typename... Fields>
    void add(const Fields&... fields) {
        (addOne(fields), ...);
    }
    void addBytes(const void* bytes, size_t size) {
        const std::string_view text(static_cast<const char*>(bytes), size);
        key_ = key_ * 0x9e3779b97f4a7c15u + std::hash<std::string_view>{}(text);
    }
    uint64_t value() const { return key_; }

  private:
    template <typename Field>
    void addOne(const Field& field) {
        static_assert(std::is_trivially_copyable_v<Field> && std::has_unique_object_representations_v<Field>);
        addBytes(&field, sizeof(field));
    }
    void addOne(float value) { addBytes(&value, sizeof(value)); }
    void addOne(const glm::vec3& v) { addBytes(&v, sizeof(v)); }
    void addOne(const glm::vec4& v) { addBytes(&v, sizeof(v)); }
    void addOne(const glm::vec2& v) { addBytes(&v, sizeof(v)); }

    uint64_t key_ = 0;
};

void addSurfaces(Key& key, const Scene& scene) {
    for (const Vertex& vertex : scene.vertices)
        key.add(vertex.position, vertex.normal, vertex.uv, vertex.uv1, vertex.colour);
    for (const Triangle& triangle : scene.triangles) key.add(triangle.vertex, triangle.material);
    for (const MeshInstance& instance : scene.instances)
        key.add(instance.mesh, instance.sceneFromMesh[0], instance.sceneFromMesh[1], instance.sceneFromMesh[2],
                instance.center);
    for (const Material& m : scene.materials) {
        key.add(m.albedo, m.emittedRadiance, m.metallic, m.roughness, m.specular, m.normalScale, m.alphaMode, m.opacity,
                m.alphaCutoff, m.unlit);
        for (const TextureUse* use :
             {&m.albedoTexture, &m.emissionTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.opacityTexture})
            key.add(use->texture, use->uvSet, use->uvMatrix[0], use->uvMatrix[1], use->uvOffset);
    }
    for (const Texture& texture : scene.textures) {
        key.add(texture.width, texture.height, texture.wrapU, texture.wrapV, texture.filter);
        key.addBytes(texture.rgba.data(), texture.rgba.size());
    }
}

}  // namespace

std::string sceneKey(const Scene& scene, const RenderSettings& settings) {
    Key key;
    addSurfaces(key, scene);
    for (const Light& light : scene.lights) {
        key.add(light.type, light.position, light.direction, light.emission, light.cosCutoff, light.cosBeam);
        if (std::isfinite(light.range)) key.add(light.range);
    }
    if (scene.environment) {
        const Image& map = scene.environment->radiance;
        key.add(map.width, map.height, scene.environment->turn);
        key.addBytes(map.texels.data(), map.texels.size() * sizeof(float));
    }
    const Camera& camera = scene.cameras[settings.camera];
    key.add(camera.origin, camera.forward, camera.up, camera.verticalFov);
    key.add(settings.width, settings.height, settings.materials, settings.lighting, settings.bounceCount.value_or(-1));
    return fmt::format("{:016x}", key.value());
}

}  // namespace manylight
