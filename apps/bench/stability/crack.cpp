#include "apps/bench/stability/crack.h"

#include "apps/bench/stability/parts.h"
#include "apps/bench/stability/ray_sets.h"
#include "engine/accel/embree_reference.h"
#include "engine/scene/import.h"
#include "engine/techniques/ray_caster.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <random>

namespace manylight {
namespace {

constexpr uint32_t kRayCount = 1'000'000;
constexpr size_t kMostParts = 32;
constexpr uint32_t kPlacesInside = 64;

glm::vec3 cornerOf(const Scene& scene, uint32_t triangle, size_t corner) {
    return scene.vertices[scene.triangles[triangle].vertex[corner]].position;
}

/// Half-way between the middle of a triangle and what Embree meets behind it. Empty if that is nothing: a triangle so
/// thin that the ray starts beside it.
std::optional<glm::vec3> placeInside(const Scene& part, const EmbreeReference& embree, uint32_t triangle, float side) {
    const glm::vec3 a = cornerOf(part, triangle, 0);
    const glm::vec3 b = cornerOf(part, triangle, 1);
    const glm::vec3 c = cornerOf(part, triangle, 2);
    const glm::vec3 across = glm::cross(b - a, c - a);
    const float length = glm::length(across);
    if (!(length > 0.0f)) return std::nullopt;
    const glm::vec3 inwards = -side * across / length;
    const glm::vec3 start = (a + b + c) / 3.0f + 1e-6f * inwards;
    const std::optional<ClosestHit> hit = embree.closest({start, 1e10f, inwards, 0.0f});
    // The far wall is met from inside, or this is a fold and not the inside.
    if (!hit || hit->t < 1e-4f || side * glm::dot(hit->normal, inwards) <= 0.0f) return std::nullopt;
    return start + 0.5f * hit->t * inwards;
}

/// Rays to the edges and corners of a closed part, from places inside it.
RaySet raysInside(const Scene& part, uint32_t count) {
    const EmbreeReference embree(part, true);
    const float side = signedVolume(part) > 0.0 ? 1.0f : -1.0f;
    std::vector<uint32_t> all(part.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    std::mt19937 random(1);
    RaySet rays;
    for (uint32_t i = 0; i < kPlacesInside; ++i) {
        const auto triangle = static_cast<uint32_t>(random() % all.size());
        const std::optional<glm::vec3> place = placeInside(part, embree, triangle, side);
        if (!place) continue;
        const RaySet fromHere = raysAtEdges(part, all, *place, 0.0f, count / kPlacesInside, i);
        rays.insert(rays.end(), fromHere.begin(), fromHere.end());
    }
    return rays;
}

Findings insideClosedParts(StabilityLab& lab, const Scene& scene) {
    const std::vector<Scene> parts = closedParts(scene, kMostParts);
    uint64_t rayCount = 0;
    uint64_t escaped = 0;
    for (const Scene& part : parts) {
        const RaySet rays = raysInside(part, kRayCount / static_cast<uint32_t>(parts.size()));
        if (rays.empty()) continue;
        rayCount += rays.size();
        escaped += escapes(lab, part, rays);
    }
    return {countIs(fmt::format("{} closed parts, {} rays: escaped", parts.size(), rayCount), escaped, 0)};
}

/// Seen from `origin` the triangles lie on different sides of the edge, and not edge-on: a ray to the edge meets one.
bool isNoOutline(const Scene& scene, const InnerEdge& edge, const glm::dvec3& origin) {
    constexpr double kClear = 1e-4;  // of the scene, which single precision resolves a thousandfold
    const glm::dvec3 a = glm::dvec3(scene.vertices[edge.ends[0]].position) - origin;
    const glm::dvec3 b = glm::dvec3(scene.vertices[edge.ends[1]].position) - origin;
    const glm::dvec3 across = glm::cross(a, b);
    const double length = glm::length(across);
    if (length < 1e-9) return false;
    const auto distance = [&](uint32_t vertex) {
        return glm::dot(across, glm::dvec3(scene.vertices[vertex].position) - origin) / length;
    };
    const double first = distance(edge.opposite[0]);
    const double second = distance(edge.opposite[1]);
    return first * second < 0.0 && std::abs(first) > kClear && std::abs(second) > kClear;
}

/// Open scenes too: rays to edges that two triangles share, which neither may let through.
Finding throughInnerEdges(StabilityLab& lab, const Scene& scene) {
    const std::vector<InnerEdge> edges = innerEdges(scene);
    std::mt19937 random(3);
    const auto uniform = [&](float low, float high) {
        return low + (high - low) * static_cast<float>(random() >> 8) * 0x1p-24f;
    };
    RaySet rays;
    for (uint32_t i = 0; i < 4 * kRayCount && rays.size() < kRayCount && !edges.empty(); ++i) {
        const InnerEdge& edge = edges[random() % edges.size()];
        glm::vec3 origin = scene.cameras.at(0).origin;
        if (i % 2 == 1)
            for (int axis = 0; axis < 3; ++axis) origin[axis] = uniform(scene.boundsMin[axis], scene.boundsMax[axis]);
        if (!isNoOutline(scene, edge, glm::dvec3(origin))) continue;
        const glm::vec3 a = scene.vertices[edge.ends[0]].position;
        const glm::vec3 b = scene.vertices[edge.ends[1]].position;
        // Up to just behind the edge: what is further away does not count.
        rays.push_back({origin, 1.001f, a + uniform(0.05f, 0.95f) * (b - a) - origin, 0.0f});
    }
    const uint64_t escaped = rays.empty() ? 0 : escapes(lab, scene, rays);
    return countIs(fmt::format("{} rays at {} inner edges: escaped", rays.size(), edges.size()), escaped, 0);
}

Finding besideEmbree(StabilityLab& lab, const Scene& scene) {
    std::vector<uint32_t> all(scene.triangles.size());
    std::iota(all.begin(), all.end(), 0u);
    RaySet rays = raysAtEdges(scene, all, scene.cameras.at(0).origin, 0.5f, kRayCount, 7);
    const EmbreeReference embree(scene, true);
    RayCaster caster(lab.device(), scene, buildBvh(scene));
    caster.load(rays);
    caster.trace(RayKind::AnyHit);
    const std::vector<uint32_t> occluded = caster.occludedFlags();
    uint64_t missedHere = 0;
    uint64_t missedThere = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const bool isHit = embree.occluded(rays[i]);
        missedHere += isHit && occluded[i] == 0 ? 1 : 0;
        missedThere += !isHit && occluded[i] != 0 ? 1 : 0;
    }
    // At an outline against the sky either answer is right, and Embree's triangles are larger by its own rounding.
    return shown(fmt::format("{} rays from the camera's side", rays.size()), "as Embree's robust mode",
                 fmt::format("{} missed here, {} there", missedHere, missedThere));
}

}  // namespace

Findings crackTest(StabilityLab& lab, const std::filesystem::path& path) {
    const Scene scene = importScene(path);
    if (scene.triangles.empty()) fail("{}: expected triangles for the crack test", path.string());
    Findings findings = insideClosedParts(lab, scene);
    findings.push_back(throughInnerEdges(lab, scene));
    findings.push_back(besideEmbree(lab, scene));
    return findings;
}

}  // namespace manylight
