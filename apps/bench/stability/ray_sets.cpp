#include "apps/bench/stability/ray_sets.h"

#include "engine/techniques/ray_caster.h"
#include "shaders/shared/bvh_ray.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace manylight {
namespace {

constexpr float kFar = 1e10f;

float uniform(std::mt19937& random) { return static_cast<float>(random() >> 8) * 0x1p-24f; }

/// The nearest t, or infinity.
float bruteForce(const Scene& scene, const shared::RayQuery& query) {
    float nearest = std::numeric_limits<float>::infinity();
    if (query.direction == glm::vec3(0.0f)) return nearest;
    const shared::TraversalRay ray = shared::makeTraversalRay(query.origin, query.direction);
    for (const Triangle& triangle : scene.triangles) {
        const shared::TriangleHit hit = shared::intersectTriangle(
            ray, scene.vertices[triangle.vertex[0]].position, scene.vertices[triangle.vertex[1]].position,
            scene.vertices[triangle.vertex[2]].position, query.tMax);
        if (hit.isHit) nearest = std::min(nearest, hit.t);
    }
    return nearest;
}

/// What both traversals say about the rays of a set.
struct Answers {
    std::vector<uint32_t> occluded;
    std::vector<shared::RayHit> hits;
    bool anyHit(size_t i) const { return occluded[i] != 0; }
    bool closestHit(size_t i) const { return hits[i].triangle != shared::kNoHit; }
};

Answers trace(StabilityLab& lab, const Scene& scene, const RaySet& rays) {
    RayCaster caster(lab.device(), scene, buildBvh(scene));
    caster.load(rays);
    Answers answers;
    caster.trace(RayKind::AnyHit);
    answers.occluded = caster.occludedFlags();
    caster.trace(RayKind::ClosestHit);
    answers.hits = caster.hits();
    return answers;
}

}  // namespace

RaySet raysAtEdges(const Scene& scene, const std::vector<uint32_t>& triangles, glm::vec3 from, float share,
                   uint32_t count, uint32_t seed) {
    std::mt19937 random(seed);
    RaySet rays;
    rays.reserve(count);
    for (uint32_t i = 0; i < count; ++i) {
        const auto& corner = scene.triangles[triangles[random() % triangles.size()]].vertex;
        const size_t first = random() % 3;
        const glm::vec3 a = scene.vertices[corner[first]].position;
        const glm::vec3 b = scene.vertices[corner[(first + 1) % 3]].position;
        const float along = i % 4 == 0 ? 0.0f : uniform(random);
        const glm::vec3 target = a + along * (b - a);
        const float start = i % 2 == 0 ? 0.0f : share * uniform(random);
        const glm::vec3 origin = from + start * (target - from);
        rays.push_back({origin, kFar, target - origin, 0.0f});
    }
    return rays;
}

RaySet signedZeroRays() {
    std::vector<glm::vec3> origins{{0.1f, 0.2f, 0.3f}};
    for (int i = 0; i < 125; ++i) origins.push_back(0.25f * glm::vec3(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2));
    constexpr float kComponents[] = {-1.0f, -0.0f, 0.0f, 1.0f};
    RaySet rays;
    for (const glm::vec3& origin : origins)
        for (uint32_t i = 0; i < 64; ++i)
            rays.push_back({origin, kFar, {kComponents[i % 4], kComponents[i / 4 % 4], kComponents[i / 16]}, 0.0f});
    return rays;
}

uint64_t escapes(StabilityLab& lab, const Scene& scene, const RaySet& rays) {
    const Answers answers = trace(lab, scene, rays);
    uint64_t count = 0;
    for (size_t i = 0; i < rays.size(); ++i) count += answers.anyHit(i) && answers.closestHit(i) ? 0 : 1;
    return count;
}

uint64_t differencesToBruteForce(StabilityLab& lab, const Scene& scene, const RaySet& rays) {
    const Answers answers = trace(lab, scene, rays);
    uint64_t count = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const float expected = bruteForce(scene, rays[i]);
        const bool isHit = std::isfinite(expected);
        const bool agrees = isHit == answers.anyHit(i) && isHit == answers.closestHit(i) &&
                            (!isHit || std::abs(answers.hits[i].t - expected) <= 1e-4f * expected + 1e-6f);
        count += agrees ? 0 : 1;
    }
    return count;
}

}  // namespace manylight
