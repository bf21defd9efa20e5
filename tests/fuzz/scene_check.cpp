#include "tests/fuzz/scene_check.h"

#include "engine/core/check.h"
#include "engine/scene/instances.h"

#include <cmath>

namespace manylight::fuzz {
namespace {

void checkUse(const TextureUse& use, const Scene& scene) {
    MANYLIGHT_CHECK(use.texture >= kNoTexture);
    MANYLIGHT_CHECK(use.texture < static_cast<int64_t>(scene.textures.size()));
    MANYLIGHT_CHECK(use.uvSet <= 1u);
    for (const glm::vec2& v : {use.uvMatrix[0], use.uvMatrix[1], use.uvOffset}) {
        MANYLIGHT_CHECK(std::isfinite(v.x));
        MANYLIGHT_CHECK(std::isfinite(v.y));
    }
}

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool isUnit(const glm::vec3& v) { return std::abs(glm::length(glm::dvec3(v)) - 1.0) < 1e-5; }

bool isEmission(const glm::vec3& v) { return isFinite(v) && v.x >= 0.0f && v.y >= 0.0f && v.z >= 0.0f; }

bool isInside(const glm::vec3& p, const glm::vec3& low, const glm::vec3& high) {
    return glm::all(glm::lessThanEqual(low, p)) && glm::all(glm::lessThanEqual(p, high));
}

void checkInstances(const Scene& scene) {
    for (const MeshInstance& instance : scene.instances) {
        MANYLIGHT_CHECK(instance.mesh < scene.meshes.size());
        MANYLIGHT_CHECK(scene.meshes[instance.mesh].triangleCount > 0u);
        MANYLIGHT_CHECK(isFinite(instance.center));
        const float determinant = glm::determinant(instance.sceneFromMesh);
        MANYLIGHT_CHECK(std::isfinite(determinant));
        MANYLIGHT_CHECK(determinant != 0.0f);
    }
    if (scene.instances.empty()) return;
    for (const Bounds& bounds : boundsOfInstances(scene, listInstances(scene)))
        for (const glm::vec3& corner : {bounds.low, bounds.high})
            MANYLIGHT_CHECK(isInside(corner, scene.boundsMin, scene.boundsMax));
}

void checkTriangles(const Scene& scene) {
    for (const Triangle& triangle : scene.triangles) {
        MANYLIGHT_CHECK(triangle.material < scene.materials.size());
        for (const uint32_t v : triangle.vertex) MANYLIGHT_CHECK(v < scene.vertices.size());
    }
    for (const Vertex& vertex : scene.vertices) {
        MANYLIGHT_CHECK((!scene.instances.empty() || isInside(vertex.position, scene.boundsMin, scene.boundsMax)));
        MANYLIGHT_CHECK((vertex.normal == glm::vec3(0.0f) || isUnit(vertex.normal)));
        MANYLIGHT_CHECK(isFinite({vertex.uv, 0.0f}));
    }
    if (scene.triangles.empty()) return;
    const double diagonal = glm::length(glm::dvec3(scene.boundsMax) - glm::dvec3(scene.boundsMin));
    MANYLIGHT_CHECK(isFinite(scene.boundsMin));
    MANYLIGHT_CHECK(isFinite(scene.boundsMax));
    MANYLIGHT_CHECK(diagonal > 0.999);
    MANYLIGHT_CHECK(diagonal < 2.001);
}

void checkMaterials(const Scene& scene) {
    for (const Material& material : scene.materials) {
        MANYLIGHT_CHECK(isInside(material.albedo, glm::vec3(0.0f), glm::vec3(1.0f)));
        MANYLIGHT_CHECK(isEmission(material.emittedRadiance));
        MANYLIGHT_CHECK(isInside(material.specular, glm::vec3(0.0f), glm::vec3(1.0f)));
        for (const float share : {material.metallic, material.roughness, material.opacity, material.alphaCutoff})
            MANYLIGHT_CHECK(isInside(glm::vec3(share), glm::vec3(0.0f), glm::vec3(1.0f)));
        for (const TextureUse& use : {material.albedoTexture, material.emissionTexture, material.normalTexture,
                                      material.metallicRoughnessTexture, material.opacityTexture})
            checkUse(use, scene);
    }
    for (const Texture& texture : scene.textures) {
        MANYLIGHT_CHECK(texture.rgba.size() > 0u);
        MANYLIGHT_CHECK(texture.rgba.size() == size_t{4} * texture.width * texture.height);
    }
}

void checkLights(const Scene& scene) {
    for (const Light& light : scene.lights) {
        MANYLIGHT_CHECK(isFinite(light.position));
        MANYLIGHT_CHECK(isEmission(light.emission));
        MANYLIGHT_CHECK(light.range >= 0.0f);
        const bool hasDirection = light.type == LightType::Spot || light.type == LightType::Directional;
        MANYLIGHT_CHECK((!hasDirection || isUnit(light.direction)));
        if (light.type != LightType::Spot) continue;
        MANYLIGHT_CHECK(std::abs(light.cosCutoff) <= 1.0f);
        MANYLIGHT_CHECK(std::abs(light.cosBeam) <= 1.0f);
        MANYLIGHT_CHECK(light.cosCutoff <= light.cosBeam);
    }
}

void checkCameras(const Scene& scene) {
    MANYLIGHT_CHECK(scene.cameras.size() > 0u);
    for (const Camera& camera : scene.cameras) {
        MANYLIGHT_CHECK(isFinite(camera.origin));
        MANYLIGHT_CHECK(isUnit(camera.forward));
        MANYLIGHT_CHECK(isUnit(camera.up));
        MANYLIGHT_CHECK(std::abs(glm::dot(camera.forward, camera.up)) < 1e-5f);
        MANYLIGHT_CHECK(camera.verticalFov > 0.0f);
        MANYLIGHT_CHECK(std::isfinite(std::tan(camera.verticalFov / 2)));
    }
}

}  // namespace

void checkScene(const Scene& scene) {
    checkTriangles(scene);
    checkInstances(scene);
    checkMaterials(scene);
    checkLights(scene);
    checkCameras(scene);
}

}  // namespace manylight::fuzz
