#include "apps/bench/ray_bench_sets.h"

#include "engine/core/error.h"

namespace manylight {
namespace {

constexpr uint32_t kLightCount = 1024;
constexpr size_t kCoherentLightCount = 8;  // no single place of a light decides the result

RaySet coherentStretches(const std::vector<SurfacePoint>& points, const std::vector<SurfacePoint>& lights) {
    RaySet rays;
    for (size_t i = 0; i < kCoherentLightCount; ++i) {
        const auto begin = points.begin() + static_cast<ptrdiff_t>(points.size() * i / kCoherentLightCount);
        const auto end = points.begin() + static_cast<ptrdiff_t>(points.size() * (i + 1) / kCoherentLightCount);
        const RaySet stretch = coherentShadowRays({begin, end}, lights[i]);
        rays.insert(rays.end(), stretch.begin(), stretch.end());
    }
    return rays;
}

}  // namespace

std::vector<BenchRays> makeBenchRays(const Scene& scene, const Camera& camera, glm::uvec2 size, uint64_t seed) {
    RaySet primary = primaryRays(camera, size.x, size.y);
    const std::vector<SurfacePoint> points = surfacePoints(scene, primary);
    const std::vector<SurfacePoint> lights = randomSurfacePoints(scene, kLightCount, seed);
    if (points.empty() || lights.empty())
        fail("{}: the camera sees no surface, so there are no rays to measure", scene.path.string());
    const RaySet bounces = diffuseBounceRays(points, seed + 1);
    return {{"primary", RayKind::ClosestHit, std::move(primary)},
            {"shadow, coherent", RayKind::AnyHit, coherentStretches(points, lights)},
            {"shadow, incoherent", RayKind::AnyHit, incoherentShadowRays(points, lights, seed + 2)},
            {"bounce", RayKind::ClosestHit, bounces},
            {"bounce", RayKind::AnyHit, bounces}};
}

}  // namespace manylight
