#include "tests/gpu/instanced_scenes.h"

#include "engine/scene/instances.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>

namespace manylight::test {

glm::mat3 turnedBy(float angle, const glm::vec3& axis, const glm::vec3& scale) {
    return glm::mat3(glm::scale(glm::rotate(glm::mat4(1.0f), angle, glm::normalize(axis)), scale));
}

void endMesh(Scene& scene) {
    const uint32_t first =
        scene.meshes.empty() ? 0 : scene.meshes.back().firstTriangle + scene.meshes.back().triangleCount;
    scene.meshes.push_back({first, static_cast<uint32_t>(scene.triangles.size()) - first, {}});
}

void addInstance(Scene& scene, uint32_t mesh, const glm::mat3& sceneFromMesh, const glm::vec3& center) {
    scene.instances.push_back({.mesh = mesh, .sceneFromMesh = sceneFromMesh, .center = center});
}

Scene finishedInstances(Scene scene) {
    const Scene flat = finished(flattened(scene));
    scene.boundsMin = flat.boundsMin;
    scene.boundsMax = flat.boundsMax;
    return scene;
}

namespace {

int32_t addDots(Scene& scene) {
    Texture texture;
    texture.width = texture.height = 2;
    texture.filter = TextureFilter::Nearest;
    texture.rgba = {255, 255, 255, 255, 80, 90, 255, 0, 200, 60, 60, 0, 255, 255, 255, 255};
    scene.textures.push_back(std::move(texture));
    return static_cast<int32_t>(scene.textures.size() - 1);
}

}  // namespace

Scene roomOfInstances() {
    Scene scene;
    const int32_t dots = addDots(scene);
    const uint32_t body = addMaterial(scene, {0.7f, 0.5f, 0.3f});
    addSphere(scene, glm::vec3(0.0f), 0.6f, 2, false, true, body);
    for (Vertex& vertex : scene.vertices) vertex.colour = {1.0f, 0.5f + 0.5f * vertex.position.y, 0.8f, 1.0f};
    endMesh(scene);
    const uint32_t card = addMaterial(scene, {0.3f, 0.8f, 0.4f});
    scene.materials[card].opacityTexture.texture = dots;
    scene.materials[card].alphaMode = AlphaMode::Mask;
    const uint32_t glass = addMaterial(scene, {0.8f, 0.8f, 0.2f});
    scene.materials[glass].culled = true;
    addQuad(scene, {-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}, card);
    addQuad(scene, {-0.3f, -0.3f, 0.3f}, {0.6f, 0, 0}, {0, 0.6f, 0}, glass);
    endMesh(scene);
    const uint32_t lamp = addMaterial(scene, glm::vec3(0.0f), {9.0f, 7.0f, 5.0f});
    scene.materials[lamp].emissionTexture.texture = dots;
    addQuad(scene, {-0.5f, 0, -0.5f}, {1, 0, 0}, {0, 0, 1}, lamp);
    endMesh(scene);
    std::array<uint32_t, 6> walls{};
    for (uint32_t i = 0; i < 6; ++i)
        walls[i] =
            addMaterial(scene, {0.5f + 0.05f * static_cast<float>(i), 0.6f, 0.8f - 0.1f * static_cast<float>(i)});
    addRoom(scene, glm::vec3(-0.5f), glm::vec3(0.5f), walls);
    endMesh(scene);

    addInstance(scene, 0, turnedBy(0.4f, {1, 2, 0}, glm::vec3(0.2f)), {-0.25f, -0.3f, -0.2f});
    addInstance(scene, 0, turnedBy(1.1f, {0, 1, 1}, {0.1f, 0.3f, 0.15f}), {0.25f, -0.22f, -0.15f});
    addInstance(scene, 0, turnedBy(2.0f, {1, 0, 1}, {0.25f, 0.08f, 0.12f}), {0.05f, 0.15f, -0.3f});
    addInstance(scene, 1, turnedBy(0.3f, {0, 1, 0}, glm::vec3(0.3f)), {-0.2f, 0.1f, -0.1f});
    addInstance(scene, 1, turnedBy(2.9f, {0.1f, 1, 0}, {0.35f, 0.25f, 0.3f}), {0.25f, 0.15f, -0.05f});
    addInstance(scene, 2, turnedBy(0.2f, {1, 0, 0}, glm::vec3(0.25f)), {0.2f, 0.4f, 0.1f});
    addInstance(scene, 2, turnedBy(0.5f, {0, 0, 1}, {0.1f, 0.2f, 0.2f}), {-0.3f, 0.35f, 0.0f});
    addInstance(scene, 3, glm::mat3(1.0f), glm::vec3(0.0f));
    addCamera(scene, {0.05f, 0.1f, 0.45f}, {0.0f, -0.05f, -0.5f}, 1.2f);
    return finishedInstances(std::move(scene));
}

}  // namespace manylight::test
