// The sets of rays that `manylight-bench rays` measures: those that a picture of the scene takes.
#pragma once

#include "engine/accel/ray_sets.h"
#include "engine/gpu/device.h"

#include <string>
#include <vector>

namespace manylight {

struct BenchRays {
    std::string name;
    RayKind kind = RayKind::AnyHit;
    RaySet rays;
};

struct BenchLights {
    std::vector<SurfacePoint> points;
    bool areVpls = false;  // otherwise random points of all surfaces: the scene has no light that leaves VPLs
};

/// About 1,000 lights, where light paths leave VPLs.
BenchLights makeBenchLights(gpu::Device& device, const Scene& scene, uint32_t seed);

/// Primary rays, one per pixel, and from what they see: shadow rays to one light per stretch of the picture (coherent)
/// and to a random one per pixel (incoherent), without the pairs that face away from each other, for which no ray is
/// needed; and diffuse bounces. Throws Error if the camera sees no surface.
std::vector<BenchRays> makeBenchRays(const Scene& scene, const Camera& camera, glm::uvec2 size,
                                     const std::vector<SurfacePoint>& lights, uint32_t seed);

}  // namespace manylight
