// The bounding volume hierarchy: Embree chooses the splits, the layout (shaders/shared/bvh.h) is ours.
#pragma once

#include "engine/scene/scene.h"
#include "shaders/shared/bvh.h"

#include <cstdint>
#include <vector>

namespace manylight {

struct BvhOptions {
    uint32_t maxLeafSize = 2;       // triangles, 1 to shared::kBvhMaxLeafSize
    float traversalCost = 1.0f;     // of one node, in the unit of the next
    float intersectionCost = 1.0f;  // of one triangle
};

/// What rays traverse. Every triangle of the scene is in exactly one leaf; a leaf is a range of `triangleOrder`.
/// Without triangles it is one node that every ray misses. A scene of instances has one tree per mesh, one behind the
/// other, and the triangles of each stay together.
struct Bvh {
    std::vector<shared::BvhNode> nodes;   // root first, siblings together
    std::vector<uint32_t> roots{0};       // node by mesh
    std::vector<uint32_t> triangleOrder;  // leaf order -> Scene::triangles
    uint32_t depth = 0;                   // nodes on the longest way down; < shared::kBvhStackSize
    // Nodes on one way down that have more inner children after the one taken, at most: a traversal in the order of
    // slots puts so many groups of siblings aside. <= shared::kBvhShortStackSize
    uint32_t putAside = 0;
};

/// Builds by the surface area heuristic. The same triangles give the same bytes on every run. Throws Error if there
/// are more than shared::kBvhMaxTriangles triangles. Corners must be finite.
Bvh buildBvh(const Scene& scene, const BvhOptions& options = {});

/// The one triangle record that rays and rasterisation share: three corners per triangle in leaf order, 16 bytes each.
/// xyz: the corner's position, the same bits as in the scene. w: bits of shared::packUnitVector(shading normal), or
/// shared::kNoNormal in all three corners where one of them has none. The bits must be copied as integers.
std::vector<glm::vec4> packTriangles(const Scene& scene, const Bvh& bvh);

}  // namespace manylight
