// The upper of two levels: a BVH over instances, and what rays need to know of each.
#pragma once

#include "engine/accel/bvh.h"
#include "engine/scene/instances.h"
#include "shaders/shared/instance.h"

namespace manylight {

struct TopLevel {
    std::vector<shared::BvhNode> nodes;  // root first; at most as many as instances
    std::vector<uint32_t> order;         // leaf -> instance; every leaf is one instance
    uint32_t depth = 0;
};

/// By the same heuristic as the BVHs of meshes. Boxes have room for the rounding of rays on their way into meshes.
TopLevel buildTopLevel(const std::vector<Bounds>& ofInstances);

/// One record per instance, and one behind them. `roots` are Bvh::roots, of nodes that start at `firstNode`.
std::vector<shared::Instance> packInstances(const InstanceList& list, const std::vector<uint32_t>& roots,
                                            const TopLevel& top, uint32_t firstNode);

/// Appends nodes whose children and triangles follow what is there: `firstTriangle` triangles, so far.
void appendNodes(std::vector<shared::BvhNode>& nodes, const std::vector<shared::BvhNode>& more, uint32_t firstTriangle);

/// Which triangle a number of the device means.
class TriangleNumbers {
  public:
    TriangleNumbers() = default;
    TriangleNumbers(InstanceList list, std::vector<uint32_t> triangleOrder);
    /// Index into Scene::triangles.
    uint32_t sceneTriangle(uint32_t number) const;
    /// Index into flattened(scene).triangles.
    uint32_t flattenedTriangle(uint32_t number) const;
    /// The number of a triangle of flattened(scene).
    uint32_t numberOfFlattened(uint32_t triangle) const;
    uint32_t count() const { return list_.firstNumbers.empty() ? 0 : list_.triangleCount(); }

  private:
    size_t instanceOf(uint32_t number) const;
    InstanceList list_;
    std::vector<uint32_t> order_;  // leaf order -> Scene::triangles
    std::vector<uint32_t> place_;  // and back
};

}  // namespace manylight
