// The sets of rays that `manylight-bench rays` measures.
#pragma once

#include "engine/accel/ray_sets.h"

#include <string>
#include <vector>

namespace manylight {

struct BenchRays {
    std::string name;
    RayKind kind = RayKind::AnyHit;
    RaySet rays;
};

/// Primary rays, one per pixel, and from what they see: shadow rays to one light per stretch of the picture (coherent)
/// and to a random one of many per pixel (incoherent), lights being where light paths might leave VPLs; and diffuse
/// bounces. Throws Error if the camera sees no surface.
std::vector<BenchRays> makeBenchRays(const Scene& scene, const Camera& camera, glm::uvec2 size, uint64_t seed);

}  // namespace manylight
