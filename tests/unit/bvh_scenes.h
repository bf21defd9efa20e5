// Meshes and rays to try a BVH on, shared by the CPU's and the device's tests.
#pragma once

#include "engine/scene/scene.h"
#include "shaders/shared/ray.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace manylight::test {

inline float uniform(std::mt19937& random, float low, float high) {
    return low + (high - low) * static_cast<float>(random() >> 8) * 0x1p-24f;
}

inline glm::vec3 randomPoint(std::mt19937& random, float low = -0.5f, float high = 0.5f) {
    const float x = uniform(random, low, high);
    const float y = uniform(random, low, high);
    return {x, y, uniform(random, low, high)};
}

inline void addTriangle(Scene& scene, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const auto first = static_cast<uint32_t>(scene.vertices.size());
    for (const glm::vec3& corner : {a, b, c}) scene.vertices.push_back({corner, glm::vec3(0.0f), glm::vec2(0.0f)});
    scene.triangles.push_back({{first, first + 1, first + 2}, 0});
}

/// `count` triangles of edge lengths up to `size` in the unit cube round the origin.
inline Scene triangleSoup(uint32_t count, float size, uint32_t seed) {
    std::mt19937 random(seed);
    Scene scene;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec3 center = randomPoint(random);
        addTriangle(scene, center + size * randomPoint(random), center + size * randomPoint(random),
                    center + size * randomPoint(random));
    }
    return scene;
}

/// A closed cube [-0.5, 0.5]^3, each face `cells` by `cells` squares of two triangles, corners welded per face and
/// equal in their bits where faces meet. `bulge` turns it towards a sphere.
inline Scene closedBox(uint32_t cells, float bulge = 0.0f) {
    Scene scene;
    for (int face = 0; face < 6; ++face) {
        const auto first = static_cast<uint32_t>(scene.vertices.size());
        for (uint32_t j = 0; j <= cells; ++j) {
            for (uint32_t i = 0; i <= cells; ++i) {
                const float u = static_cast<float>(i) / static_cast<float>(cells) - 0.5f;
                const float v = static_cast<float>(j) / static_cast<float>(cells) - 0.5f;
                glm::vec3 p{0.0f};
                p[face % 3] = face < 3 ? 0.5f : -0.5f;
                p[(face + 1) % 3] = u;
                p[(face + 2) % 3] = v;
                // Products of the coordinates in a fixed order: an edge has the same bits on both its faces.
                const float squares = p.x * p.x + p.y * p.y + p.z * p.z;
                scene.vertices.push_back({p * (1.0f + bulge * (0.75f - squares)), glm::vec3(0.0f), glm::vec2(0.0f)});
            }
        }
        for (uint32_t j = 0; j < cells; ++j) {
            for (uint32_t i = 0; i < cells; ++i) {
                const uint32_t a = first + j * (cells + 1) + i;
                const uint32_t d = a + cells + 1;
                scene.triangles.push_back({{a, a + 1, d + 1}, 0});
                scene.triangles.push_back({{a, d + 1, d}, 0});
            }
        }
    }
    return scene;
}

/// From random points of the cube in random directions; every fourth ray ends early.
inline std::vector<shared::RayQuery> randomRays(uint32_t count, uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<shared::RayQuery> rays;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec3 origin = randomPoint(random, -0.7f, 0.7f);
        const glm::vec3 direction = randomPoint(random, -0.7f, 0.7f) - origin;
        rays.push_back({origin, i % 4 == 0 ? uniform(random, 0.0f, 1.0f) : 1e10f, direction, 0.0f});
    }
    return rays;
}

/// All directions of {-1, -0, 0, 1}^3, the zero ones among them, from points of the grid {-0.5, -0.25, ..., 0.5}^3 and
/// from one that is on no plane of it.
inline std::vector<shared::RayQuery> signedZeroRays() {
    std::vector<glm::vec3> origins{{0.1f, 0.2f, 0.3f}};
    for (int i = 0; i < 125; ++i) origins.push_back(0.25f * glm::vec3(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2));
    constexpr std::array<float, 4> kComponents{-1.0f, -0.0f, 0.0f, 1.0f};
    std::vector<shared::RayQuery> rays;
    for (const glm::vec3& origin : origins) {
        for (uint32_t i = 0; i < 64; ++i) {
            rays.push_back({origin, 1e10f, {kComponents[i % 4], kComponents[i / 4 % 4], kComponents[i / 16]}, 0.0f});
        }
    }
    return rays;
}

/// From points well inside a closed mesh to its vertices and to points of its edges.
inline std::vector<shared::RayQuery> raysAtEdges(const Scene& scene, uint32_t count, uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<shared::RayQuery> rays;
    for (uint32_t i = 0; i < count; ++i) {
        const auto& corner = scene.triangles[random() % scene.triangles.size()].vertex;
        const uint32_t first = static_cast<uint32_t>(random() % 3);
        const glm::vec3 a = scene.vertices[corner[first]].position;
        const glm::vec3 b = scene.vertices[corner[(first + 1) % 3]].position;
        const float along = i % 4 == 0 ? 0.0f : uniform(random, 0.0f, 1.0f);
        const glm::vec3 origin = i % 2 == 0 ? glm::vec3(0.0f) : 0.5f * randomPoint(random);
        rays.push_back({origin, 1e10f, a + along * (b - a) - origin, 0.0f});
    }
    return rays;
}

}  // namespace manylight::test
