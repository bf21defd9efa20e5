// Rays that must not slip through, and rays along the axes.
#include "apps/bench/stability/families.h"
#include "apps/bench/stability/ray_sets.h"
#include "apps/bench/stability/scenes.h"
#include "apps/bench/stability/solids.h"
#include "shaders/shared/ray_offset.h"

#include <cmath>
#include <numeric>
#include <random>

namespace manylight::stability {
namespace {

std::vector<uint32_t> allTriangles(const Scene& scene) {
    std::vector<uint32_t> indices(scene.triangles.size());
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

Finding noneEscapes(StabilityLab& lab, const std::string& what, const Scene& scene, uint32_t count) {
    const glm::vec3 inside = 0.5f * (scene.boundsMin + scene.boundsMax);
    const RaySet rays = raysAtEdges(scene, allTriangles(scene), inside, 0.5f, count, 1);
    return countIs(fmt::format("{}: {} rays, escaped", what, count), escapes(lab, scene, rays), 0);
}

Scene icosphere(int levels, double aspect) {
    RawScene raw = emptyScene();
    addSphere(raw, glm::dvec3(0.3, 0.1, -0.2), 0.5, levels, false, false, addMaterial(raw, glm::dvec3(0.5)));
    for (RawVertex& vertex : raw.vertices) vertex.position.x *= aspect;
    return normalise(std::move(raw));
}

/// A closed box with strips across that are 1e-6 as wide as long.
Scene boxWithSlivers() {
    RawScene raw = emptyScene();
    const uint32_t grey = addMaterial(raw, glm::dvec3(0.5));
    addRoom(raw, glm::dvec3(-0.5), glm::dvec3(0.5), grey, 3);
    // Grid lines at +-1/6 come to lie 1e-6 apart, on all six faces alike.
    for (RawVertex& vertex : raw.vertices)
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(vertex.position[axis]) < 0.4) vertex.position[axis] *= 3e-6;
    return normalise(std::move(raw));
}

Findings watertightWith(StabilityLab& lab, uint32_t count) {
    Findings findings;
    findings.push_back(noneEscapes(lab, "sphere of 32768", icosphere(6, 1.0), count));
    findings.push_back(noneEscapes(lab, "the same, flat as 1e-4", icosphere(6, 1e-4), count));
    RawScene box = emptyScene();
    addRoom(box, glm::dvec3(-0.5), glm::dvec3(0.5), addMaterial(box, glm::dvec3(0.5)), 30);
    findings.push_back(noneEscapes(lab, "box", normalise(std::move(box)), count));
    findings.push_back(noneEscapes(lab, "box with slivers of 1e-6", boxWithSlivers(), count));
    const std::vector<Scene> solids = courtyardSolids(8);
    uint64_t escaped = 0;
    for (const Scene& solid : solids)
        escaped += escapes(
            lab, solid,
            raysAtEdges(solid, allTriangles(solid), 0.5f * (solid.boundsMin + solid.boundsMax), 0.5f, count / 8, 1));
    findings.push_back(countIs(
        fmt::format("{} solids of the courtyard: {} rays", solids.size(), count / 8 * solids.size()), escaped, 0));
    findings.push_back(holds("solids found", "8", fmt::format("{}", solids.size()), solids.size() == 8));
    return findings;
}

}  // namespace

Findings watertight(StabilityLab& lab) { return watertightWith(lab, 100'000); }

Findings watertightMillion(StabilityLab& lab) { return watertightWith(lab, 1'000'000); }

Findings signedZeros(StabilityLab& lab) {
    Findings findings;
    const RaySet rays = signedZeroRays();
    const auto room = [](uint32_t cells) {
        RawScene raw = emptyScene();
        addRoom(raw, glm::dvec3(-0.5), glm::dvec3(0.5), addMaterial(raw, glm::dvec3(0.5)), cells);
        return normalise(std::move(raw));
    };
    // The grid of 4 cells has its planes and edges where the rays start and run; that of 3 has not.
    for (const uint32_t cells : {4u, 3u})
        findings.push_back(countIs(fmt::format("{} rays, room of {} cells: differ", rays.size(), cells),
                                   differencesToBruteForce(lab, room(cells), rays), 0));
    findings.push_back(
        countIs("furnished room: differ", differencesToBruteForce(lab, normalise(furnishedRoom()), rays), 0));
    return findings;
}

Findings oneCentroid(StabilityLab& lab) {
    // No split of the centroids tells these apart.
    Findings findings;
    std::mt19937 random(1);
    const auto direction = [&] {
        const auto u = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
        return glm::dvec3(u(), u(), u());
    };
    for (const uint32_t count : {1u, 2u, 3u, 4u, 5u, 1000u}) {
        RawScene raw = emptyScene();
        addMaterial(raw, glm::dvec3(0.5));
        for (uint32_t i = 0; i < count; ++i) {
            const glm::dvec3 a = direction();
            const glm::dvec3 b = direction();
            addTriangle(raw, a, b, -a - b, 0);
        }
        const Scene scene = normalise(std::move(raw));
        RaySet rays;
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 origin(2.0 * direction());
            rays.push_back({origin, 1e10f, glm::vec3(direction()) - origin, 0.0f});
        }
        findings.push_back(countIs(fmt::format("{} triangles: rays that differ", count),
                                   differencesToBruteForce(lab, scene, rays), 0));
    }
    return findings;
}

Findings rayOffsets(StabilityLab&) {
    // A point leaves its surface by more than the rounding of a hit, and by no more than rounding leaves of that.
    Findings findings;
    for (const float coordinate : {1e-6f, 1.0f / 32.0f, 0.1f, 0.5f, 1.0f, -0.3f, -1.0f}) {
        const glm::vec3 position(coordinate, 0.2f, -0.7f);
        const float moved = shared::offsetPoint(position, {1, 0, 0}).x - coordinate;
        const bool isRight = moved > 5e-7f && moved <= 4e-6f;
        findings.push_back(
            holds(fmt::format("at {}", coordinate), "5e-7 to 4e-6", fmt::format("{:.2e}", moved), isRight));
    }
    return findings;
}

}  // namespace manylight::stability
