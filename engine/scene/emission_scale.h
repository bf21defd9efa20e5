// Emission of surfaces as the user scaled it, beside what the scene file gives.
#pragma once

#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace manylight {

inline constexpr float kLargestEmissionScale = 1e6f;

/// The material emits `scale` times Material::givenRadiance from now on, but no more than a float holds.
void scaleEmission(Material& material, float scale);

/// Of all materials of that name. False if none of them shines.
bool scaleEmission(Scene& scene, const std::string& material, float scale);

/// What shines and is a surface, by the name of its material, which several may have.
struct SurfaceEmitter {
    std::string material;
    float scale = 1.0f;
    glm::vec3 givenRadiance{0.0f};  // of the first of that name
};
/// Without repeats, in the order of the scene's materials.
std::vector<SurfaceEmitter> surfaceEmitters(const Scene& scene);

}  // namespace manylight
