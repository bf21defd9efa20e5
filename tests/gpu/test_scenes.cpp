#include "tests/gpu/test_scenes.h"

#include "engine/core/check.h"
#include "engine/scene/import.h"

#include <cmath>

namespace manylight::test {
namespace {

uint32_t addVertex(Scene& scene, glm::vec3 position, glm::vec3 normal = glm::vec3(0.0f), glm::vec2 uv = {0, 0}) {
    scene.vertices.push_back({position, normal, uv});
    return static_cast<uint32_t>(scene.vertices.size() - 1);
}

struct Sphere {
    glm::vec3 center;
    float radius;
    bool inwards;
    bool smooth;
    uint32_t material;
};

/// `a`, `b`, `c` are unit directions, counter-clockwise seen from outside.
void addSpherePatch(Scene& scene, const Sphere& sphere, glm::vec3 a, glm::vec3 b, glm::vec3 c, int levels) {
    if (levels > 0) {
        const glm::vec3 ab = glm::normalize(a + b);
        const glm::vec3 bc = glm::normalize(b + c);
        const glm::vec3 ca = glm::normalize(c + a);
        addSpherePatch(scene, sphere, a, ab, ca, levels - 1);
        addSpherePatch(scene, sphere, ab, b, bc, levels - 1);
        addSpherePatch(scene, sphere, ca, bc, c, levels - 1);
        addSpherePatch(scene, sphere, ab, bc, ca, levels - 1);
        return;
    }
    const auto corner = [&](glm::vec3 direction) {
        const glm::vec3 normal = sphere.smooth ? (sphere.inwards ? -direction : direction) : glm::vec3(0.0f);
        return addVertex(scene, sphere.center + sphere.radius * direction, normal);
    };
    const uint32_t first = corner(a);
    const uint32_t second = corner(sphere.inwards ? c : b);
    const uint32_t third = corner(sphere.inwards ? b : c);
    scene.triangles.push_back({{first, second, third}, sphere.material});
}

Texture checkerTexture() {
    Texture texture;
    texture.name = "checker";
    texture.width = 4;
    texture.height = 4;
    for (uint32_t i = 0; i < 16; ++i) {
        const bool light = (i + i / 4) % 2 == 0;
        const auto level = static_cast<uint8_t>(light ? 230 : 90);
        texture.rgba.insert(texture.rgba.end(), {level, static_cast<uint8_t>(level / 2), 200, 255});
    }
    return texture;
}

}  // namespace

uint32_t addMaterial(Scene& scene, glm::vec3 albedo, glm::vec3 emittedRadiance) {
    Material material;
    material.albedo = albedo;
    material.emittedRadiance = emittedRadiance;
    scene.materials.push_back(material);
    return static_cast<uint32_t>(scene.materials.size() - 1);
}

void addQuad(Scene& scene, glm::vec3 corner, glm::vec3 u, glm::vec3 v, uint32_t material) {
    const uint32_t first = addVertex(scene, corner);
    addVertex(scene, corner + u, glm::vec3(0.0f), {1, 0});
    addVertex(scene, corner + u + v, glm::vec3(0.0f), {1, 1});
    addVertex(scene, corner + v, glm::vec3(0.0f), {0, 1});
    scene.triangles.push_back({{first, first + 1, first + 2}, material});
    scene.triangles.push_back({{first, first + 2, first + 3}, material});
}

void addRoom(Scene& scene, glm::vec3 low, glm::vec3 high, const std::array<uint32_t, 6>& materials) {
    const glm::vec3 x(high.x - low.x, 0, 0);
    const glm::vec3 y(0, high.y - low.y, 0);
    const glm::vec3 z(0, 0, high.z - low.z);
    addQuad(scene, low, y, z, materials[0]);
    addQuad(scene, low + x, z, y, materials[1]);
    addQuad(scene, low, z, x, materials[2]);
    addQuad(scene, low + y, x, z, materials[3]);
    addQuad(scene, low, x, y, materials[4]);
    addQuad(scene, low + z, y, x, materials[5]);
}

void addRoom(Scene& scene, glm::vec3 low, glm::vec3 high, uint32_t material) {
    addRoom(scene, low, high, {material, material, material, material, material, material});
}

void addSphere(Scene& scene, glm::vec3 center, float radius, int levels, bool inwards, bool smooth, uint32_t material) {
    const Sphere sphere{center, radius, inwards, smooth, material};
    for (const float sx : {-1.0f, 1.0f})
        for (const float sy : {-1.0f, 1.0f})
            for (const float sz : {-1.0f, 1.0f}) {
                const glm::vec3 x(sx, 0, 0);
                const glm::vec3 y(0, sy, 0);
                const glm::vec3 z(0, 0, sz);
                if (sx * sy * sz > 0.0f)
                    addSpherePatch(scene, sphere, x, y, z, levels);
                else
                    addSpherePatch(scene, sphere, x, z, y, levels);
            }
}

void addCamera(Scene& scene, glm::vec3 origin, glm::vec3 target, float verticalFov) {
    Camera camera;
    camera.origin = origin;
    camera.forward = glm::normalize(target - origin);
    const glm::vec3 sky = std::abs(camera.forward.y) > 0.9f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
    camera.up = glm::normalize(sky - glm::dot(sky, camera.forward) * camera.forward);
    camera.verticalFov = verticalFov;
    scene.cameras.push_back(camera);
}

Light pointLight(glm::vec3 position, glm::vec3 intensity) {
    Light light;
    light.type = LightType::Point;
    light.position = position;
    light.emission = intensity;
    return light;
}

Light spotLight(glm::vec3 position, glm::vec3 direction, glm::vec3 intensity, float beamAngle, float cutoffAngle) {
    Light light = pointLight(position, intensity);
    light.type = LightType::Spot;
    light.direction = glm::normalize(direction);
    light.cosBeam = std::cos(beamAngle);
    light.cosCutoff = std::cos(cutoffAngle);
    return light;
}

Light directionalLight(glm::vec3 direction, glm::vec3 irradiance) {
    Light light;
    light.type = LightType::Directional;
    light.direction = glm::normalize(direction);
    light.emission = irradiance;
    return light;
}

Light constantLight(glm::vec3 radiance) {
    Light light;
    light.type = LightType::Constant;
    light.emission = radiance;
    return light;
}

Scene finished(Scene scene) {
    scene.boundsMin = scene.boundsMax = scene.vertices.front().position;
    for (const Vertex& vertex : scene.vertices) {
        scene.boundsMin = glm::min(scene.boundsMin, vertex.position);
        scene.boundsMax = glm::max(scene.boundsMax, vertex.position);
    }
    const float diagonal = glm::length(scene.boundsMax - scene.boundsMin);
    MANYLIGHT_CHECK(diagonal >= 1.0f, "a test's scene");
    MANYLIGHT_CHECK(diagonal < 2.0f, "a test's scene");
    return scene;
}

Scene closedBox(glm::vec3 albedo, glm::vec3 emittedRadiance) {
    Scene scene;
    addRoom(scene, glm::vec3(-0.5f), glm::vec3(0.5f), addMaterial(scene, albedo, emittedRadiance));
    addCamera(scene, {0.05f, 0.1f, 0.35f}, {0.0f, -0.1f, -0.5f}, 1.2f);
    return finished(std::move(scene));
}

Scene unevenBox() {
    Scene scene;
    std::array<uint32_t, 6> walls{};
    const glm::vec3 albedos[] = {{0.7f, 0.1f, 0.1f}, {0.1f, 0.6f, 0.2f}, {0.8f, 0.8f, 0.7f},
                                 {0.5f, 0.5f, 0.5f}, {0.3f, 0.4f, 0.9f}, {0.2f, 0.2f, 0.2f}};
    for (size_t i = 0; i < walls.size(); ++i) walls[i] = addMaterial(scene, albedos[i]);
    addRoom(scene, glm::vec3(-0.5f), glm::vec3(0.5f), walls);
    addCamera(scene, {0.05f, 0.1f, 0.35f}, {0.0f, -0.1f, -0.5f}, 1.2f);
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.05f}, {1.0f, 0.8f, 0.6f}));
    return finished(std::move(scene));
}

Scene floorFromAbove(float albedo) {
    Scene scene;
    addQuad(scene, {-0.5f, 0, -0.5f}, {0, 0, 1}, {1, 0, 0}, addMaterial(scene, glm::vec3(albedo)));
    addCamera(scene, {0, 0.6f, 0}, {0, 0, 0}, 1.0f);
    return finished(std::move(scene));
}

Scene everyKindOfLight() {
    Scene scene;
    scene.textures.push_back(checkerTexture());
    const uint32_t grey = addMaterial(scene, glm::vec3(0.6f));
    const uint32_t checker = addMaterial(scene, glm::vec3(0.9f));
    scene.materials[checker].albedoTexture.texture = 0;
    const uint32_t lamp = addMaterial(scene, glm::vec3(0.0f), {4.0f, 3.0f, 2.0f});
    addQuad(scene, {-0.5f, -0.4f, -0.5f}, {0, 0, 1}, {1, 0, 0}, checker);
    addQuad(scene, {-0.5f, -0.4f, -0.5f}, {1, 0, 0}, {0, 0.8f, 0}, checker);
    addQuad(scene, {-0.5f, -0.4f, -0.5f}, {0, 0.8f, 0}, {0, 0, 1}, grey);
    addSphere(scene, {0.1f, -0.15f, -0.1f}, 0.2f, 3, false, true, grey);
    addQuad(scene, {-0.2f, 0.38f, -0.2f}, {0.3f, 0, 0}, {0, 0, 0.2f}, lamp);
    addCamera(scene, {0.4f, 0.3f, 1.1f}, {0, -0.1f, -0.1f}, 0.8f);
    scene.lights = {pointLight({0.3f, 0.2f, 0.4f}, glm::vec3(0.2f)),
                    spotLight({-0.4f, 0.35f, 0.4f}, {0.5f, -0.6f, -0.5f}, {0.5f, 0.4f, 0.1f}, 0.2f, 0.5f),
                    directionalLight({-0.2f, -1.0f, -0.3f}, {0.3f, 0.3f, 0.5f}), constantLight({0.1f, 0.15f, 0.3f})};
    return finished(std::move(scene));
}

Scene sphereInBox() {
    Scene scene = unevenBox();
    scene.lights[0].emission *= 0.3f;
    addSphere(scene, {-0.2f, -0.2f, -0.2f}, 0.2f, 2, false, false, addMaterial(scene, {0.7f, 0.5f, 0.3f}));
    addQuad(scene, {-0.1f, 0.45f, -0.3f}, {0.3f, 0, 0}, {0, 0, 0.3f},
            addMaterial(scene, glm::vec3(0.3f), {3.0f, 4.0f, 5.0f}));
    scene.cameras.clear();
    addCamera(scene, {0.35f, 0.1f, 0.4f}, {-0.25f, -0.25f, -0.3f}, 0.9f);
    return finished(std::move(scene));
}

Scene twoRooms() {
    Scene scene;
    const uint32_t wall = addMaterial(scene, {0.8f, 0.75f, 0.7f});
    addRoom(scene, {-0.5f, -0.3f, -0.3f}, {0.5f, 0.3f, 0.3f}, wall);
    addQuad(scene, {0.0f, -0.3f, -0.3f}, {0, 0, 0.3f}, {0, 0.6f, 0}, wall);
    addQuad(scene, {-0.35f, 0.29f, -0.15f}, {0.2f, 0, 0}, {0, 0, 0.2f},
            addMaterial(scene, glm::vec3(0.0f), {10.0f, 9.0f, 7.0f}));
    addCamera(scene, {0.45f, 0.05f, -0.2f}, {0.05f, -0.1f, 0.1f}, 1.0f);
    return finished(std::move(scene));
}

Scene cornellBox() { return importScene(std::filesystem::path(MANYLIGHT_SOURCE_DIR) / "scenes" / "cornell_box.json"); }

}  // namespace manylight::test
