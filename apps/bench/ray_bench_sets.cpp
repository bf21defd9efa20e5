#include "apps/bench/ray_bench_sets.h"

#include "engine/core/error.h"
#include "engine/techniques/renderer.h"

#include <functional>
#include <random>

namespace manylight {
namespace {

constexpr uint32_t kLightCount = 1024;
constexpr size_t kStretchCount = 8;  // so that no single light decides the result

std::vector<SurfacePoint> tracedVpls(gpu::Device& device, const Scene& scene, uint32_t seed) {
    RenderSettings settings;
    settings.width = settings.height = 8;
    settings.vplCount = kLightCount;
    settings.castShadows = false;
    settings.seed = seed;
    Renderer renderer(device, scene, settings);
    renderer.keepVpls();
    renderer.renderFrame();
    std::vector<SurfacePoint> points;
    if (!renderer.plan().lightPaths) return points;
    for (const shared::LightData& vpl : renderer.vpls())
        if (vpl.intensity > 0.0f) points.push_back({vpl.position, vpl.direction});
    return points;
}

bool faceEachOther(const SurfacePoint& a, const SurfacePoint& b) {
    const glm::vec3 along = b.position - a.position;
    return glm::dot(a.normal, along) > 0.0f && glm::dot(b.normal, along) < 0.0f;
}

RaySet shadowRays(const std::vector<SurfacePoint>& points, const std::vector<SurfacePoint>& lights,
                  const std::function<size_t(size_t)>& lightOfPoint) {
    RaySet rays;
    for (size_t i = 0; i < points.size(); ++i) {
        const SurfacePoint& light = lights[lightOfPoint(i)];
        if (faceEachOther(points[i], light)) rays.push_back(shadowRay(points[i], light));
    }
    return rays;
}

}  // namespace

BenchLights makeBenchLights(gpu::Device& device, const Scene& scene, uint32_t seed) {
    std::vector<SurfacePoint> vpls = tracedVpls(device, scene, seed);
    if (vpls.size() >= kStretchCount) return {std::move(vpls), true};
    return {randomSurfacePoints(scene, kLightCount, seed), false};
}

std::vector<BenchRays> makeBenchRays(const Scene& scene, const Camera& camera, glm::uvec2 size,
                                     const std::vector<SurfacePoint>& lights, uint32_t seed) {
    RaySet primary = primaryRays(camera, size.x, size.y);
    const std::vector<SurfacePoint> points = surfacePoints(scene, primary);
    if (points.empty() || lights.empty())
        fail("{}: the camera sees no surface, so there are no rays to measure", scene.path.string());
    // A light takes one stretch of the picture; the lights are spread over the list, which is in the order of bounces.
    const auto lightOfStretch = [&](size_t i) {
        const size_t stretch = i * kStretchCount / points.size();
        return (2 * stretch + 1) * lights.size() / (2 * kStretchCount);
    };
    std::mt19937_64 random(seed);
    const auto anyLight = [&](size_t) { return random() % lights.size(); };
    RaySet coherent = shadowRays(points, lights, lightOfStretch);
    RaySet incoherent = shadowRays(points, lights, anyLight);
    const RaySet bounces = diffuseBounceRays(points, seed + 1);
    return {{"primary", RayKind::ClosestHit, std::move(primary)},
            {"shadow, coherent", RayKind::AnyHit, std::move(coherent)},
            {"shadow, incoherent", RayKind::AnyHit, std::move(incoherent)},
            {"bounce", RayKind::ClosestHit, bounces},
            {"bounce", RayKind::AnyHit, bounces}};
}

}  // namespace manylight
