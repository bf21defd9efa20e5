// Sets of rays that a renderer would trace, for measuring and for testing.
#pragma once

#include "engine/scene/scene.h"
#include "shaders/shared/ray.h"

#include <cstdint>
#include <vector>

namespace manylight {

using RaySet = std::vector<shared::RayQuery>;

/// What is asked about a ray.
enum class RayKind : uint8_t { AnyHit, ClosestHit };

/// One ray through the centre of each of width * height pixels, in Morton order (neighbours in the list are
/// neighbours in the picture). tMax is infinite for practical purposes.
RaySet primaryRays(const Camera& camera, uint32_t width, uint32_t height);

/// A point seen by a ray of a set and the geometric normal there, turned to the ray's origin.
struct SurfacePoint {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
};

/// Where `rays` first meet the scene (found by Embree); rays that miss are left out.
std::vector<SurfacePoint> surfacePoints(const Scene& scene, const RaySet& rays);

/// Points spread uniformly by area over all triangles, on the side of the triangle's normal.
std::vector<SurfacePoint> randomSurfacePoints(const Scene& scene, uint32_t count, uint64_t seed);

/// t runs from 0 to 1 between the ends, both moved off their surfaces; a hit is an occluder.
shared::RayQuery shadowRay(const SurfacePoint& point, const SurfacePoint& light);

/// All points to one.
RaySet coherentShadowRays(const std::vector<SurfacePoint>& points, const SurfacePoint& light);

/// Each point to one of `lights`, chosen at random per point.
RaySet incoherentShadowRays(const std::vector<SurfacePoint>& points, const std::vector<SurfacePoint>& lights,
                            uint64_t seed);

/// One cosine-distributed ray from each point.
RaySet diffuseBounceRays(const std::vector<SurfacePoint>& points, uint64_t seed);

}  // namespace manylight
