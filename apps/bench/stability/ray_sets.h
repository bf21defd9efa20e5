// Rays that are hard to trace, and what they must meet.
#pragma once

#include "apps/bench/stability/lab.h"
#include "engine/accel/ray_sets.h"

namespace manylight {

/// To vertices and points of edges of the triangles, every second ray from `from`, the others from somewhere on the
/// first `share` of the way.
RaySet raysAtEdges(const Scene& scene, const std::vector<uint32_t>& triangles, glm::vec3 from, float share,
                   uint32_t count, uint32_t seed);
/// All directions of {-1, -0, 0, 1}^3, from points of a grid through the scene and from one that is on no plane of it.
RaySet signedZeroRays();

/// Rays that meet nothing on the device.
uint64_t escapes(StabilityLab& lab, const Scene& scene, const RaySet& rays);
/// Rays of which the device says something else than the same triangle test on all triangles, on the processor.
uint64_t differencesToBruteForce(StabilityLab& lab, const Scene& scene, const RaySet& rays);

}  // namespace manylight
