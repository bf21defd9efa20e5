// The emitter table: every light and emissive triangle, with the probabilities by which light paths choose among them.
#pragma once

#include "engine/scene/scene.h"
#include "shaders/shared/lights.h"

#include <cstdint>
#include <vector>

namespace manylight {

struct EmitterTable {
    std::vector<shared::Emitter> emitters;  // point, spot and directional lights first
    uint32_t deltaLightCount = 0;           // how many of these there are
    uint32_t areaLightCount = 0;            // emissive triangles and the environment
    glm::vec3 environmentRadiance{0.0f};    // sum of constant lights
    double totalPower = 0.0;                // W in the normalised frame, mean of the channels
    // Emitter::probability = powerShare * its power + equalShare.
    double powerShare = 0.0;
    double equalShare = 0.0;
    double environmentProbability = 0.0;  // of all constant lights together
    // The same for Emitter::areaProbability.
    double areaPowerShare = 0.0;
    double areaEqualShare = 0.0;
    double areaEnvironmentProbability = 0.0;
};

/// P = 0.9 * share of power + 0.1 / count: a weak light among strong ones keeps its share of paths (Hesterberg 1995's
/// defensive mixture). Lights of no power are left out. `sceneRadius`: of the sphere that directional light and
/// the environment must cover. Emitter::triangle counts the triangles of all instances; Emitter::emissionTexture is
/// left to who packs the textures.
EmitterTable buildEmitterTable(const Scene& scene, float sceneRadius);

/// Mean channel of the radiance that a material emits, over its texture.
double meanEmission(const Scene& scene, const Material& material);

/// Sphere around the scene's bounds.
struct BoundingSphere {
    glm::vec3 center{0.0f};
    float radius = 1.0f;
};
BoundingSphere boundingSphere(const Scene& scene);

}  // namespace manylight
