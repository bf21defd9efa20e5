#include "engine/scene/emission_scale.h"

#include <algorithm>
#include <limits>

namespace manylight {
namespace {

bool shines(const Material& material) { return material.givenRadiance != glm::vec3(0.0f); }

}  // namespace

void scaleEmission(Material& material, float scale) {
    const glm::dvec3 radiance = double{scale} * glm::dvec3(material.givenRadiance);
    material.emissionScale = scale;
    material.emittedRadiance = glm::vec3(glm::min(radiance, double{std::numeric_limits<float>::max()}));
}

bool scaleEmission(Scene& scene, const std::string& material, float scale) {
    bool isFound = false;
    for (Material& candidate : scene.materials) {
        if (candidate.name != material || !shines(candidate)) continue;
        scaleEmission(candidate, scale);
        isFound = true;
    }
    return isFound;
}

std::vector<SurfaceEmitter> surfaceEmitters(const Scene& scene) {
    std::vector<SurfaceEmitter> emitters;
    for (const Material& material : scene.materials)
        if (shines(material) && std::ranges::find(emitters, material.name, &SurfaceEmitter::material) == emitters.end())
            emitters.push_back({material.name, material.emissionScale, material.givenRadiance});
    return emitters;
}

}  // namespace manylight
