#include "engine/scene/instances.h"
#include "engine/scene/normalise_parts.h"

#include "shaders/shared/constants.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

constexpr float kFurthestLight = 1e4f;  // radii of the scene; a camera further away sees less than a pixel of it
constexpr float kDefaultFov = 50.0f * shared::kPi / 180.0f;

float halfDiagonal(const Scene& scene) {
    const float half = 0.5f * glm::length(scene.boundsMax - scene.boundsMin);
    return half > 0.0f ? half : 0.5f;
}

size_t countEmissiveTriangles(const Scene& scene, glm::vec3 Material::*radiance = &Material::emittedRadiance) {
    return static_cast<size_t>(std::count_if(scene.triangles.begin(), scene.triangles.end(), [&](const Triangle& t) {
        return scene.materials[t.material].*radiance != glm::vec3(0.0f);
    }));
}

/// An emitter that the user put out is none that is missing.
bool hasAnyLight(const Scene& scene) {
    return countEmissiveTriangles(scene, &Material::givenRadiance) > 0 || scene.environment ||
           std::any_of(scene.lights.begin(), scene.lights.end(),
                       [](const Light& l) { return l.emission != glm::vec3(0.0f); });
}

}  // namespace

void addMissingCamera(Scene& scene) {
    if (!scene.cameras.empty()) return;
    // The bounding sphere touches the frame's top and bottom: the whole scene is in view, from the front upper right.
    const float distance = halfDiagonal(scene) / std::sin(0.5f * kDefaultFov);
    const glm::vec3 center = 0.5f * (scene.boundsMin + scene.boundsMax);
    const glm::vec3 forward = -glm::normalize(glm::vec3(0.45f, 0.35f, 1.0f));
    const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
    Camera camera;
    camera.name = "default";
    camera.origin = center - distance * forward;
    camera.forward = forward;
    camera.up = glm::cross(right, forward);
    camera.verticalFov = kDefaultFov;
    scene.cameras.push_back(std::move(camera));
    scene.warnings.add("scenes without a camera: given one that sees all of it");
}

void addMissingLight(Scene& scene) {
    if (hasAnyLight(scene)) return;
    const Camera& camera = scene.cameras.front();
    const float radius = halfDiagonal(scene);
    const glm::vec3 center = 0.5f * (scene.boundsMin + scene.boundsMax);
    Light light;
    light.name = "default";
    light.position = camera.origin + 0.05f * radius * camera.up;
    // L = albedo / pi * I / d²: an albedo of 0.5 at the distance of the centre reflects the radiance 0.18, mid grey.
    const float distance = std::clamp(glm::distance(light.position, center), radius, kFurthestLight * radius);
    light.emission = glm::vec3(0.18f / 0.5f * shared::kPi * distance * distance);
    scene.lights.push_back(std::move(light));
    scene.warnings.add("scenes without a light: given a point light near the camera");
}

void reportMissingLight(Scene& scene) {
    if (!hasAnyLight(scene)) scene.warnings.add("scenes without a light: black, as the list of lights asks for");
}

void fillImportReport(Scene& scene, size_t trianglesRead) {
    scene.importReport = Json{{"trianglesRead", trianglesRead},
                              {"triangles", shownTriangles(scene)},
                              {"trianglesStored", scene.triangles.size()},
                              {"instances", scene.instances.size()},
                              {"vertices", scene.vertices.size()},
                              {"materials", scene.materials.size()},
                              {"textures", scene.textures.size()},
                              {"lights", scene.lights.size()},
                              {"environmentMaps", scene.environment ? 1 : 0},
                              {"emissiveTriangles", countEmissiveTriangles(scene)},
                              {"cameras", scene.cameras.size()}};
}

}  // namespace manylight
