// The binary tree between the builders and the layout; internal to engine/accel.
#pragma once

#include "engine/accel/bvh.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace manylight {

struct Box {
    glm::vec3 lower{0.0f};
    glm::vec3 upper{0.0f};
};

Box merge(const Box& a, const Box& b);

/// A leaf is a range of BuildTree::order, an inner node has two children, which come after it.
struct BuildNode {
    Box box;
    std::array<uint32_t, 2> children{};
    uint32_t first = 0;
    uint32_t count = 0;  // 0: inner
};

struct BuildTree {
    std::vector<BuildNode> nodes;  // root first; none without triangles
    std::vector<uint32_t> order;   // the triangles of the leaves
};

std::vector<Box> triangleBoxes(const Scene& scene);

/// By Embree's binned surface area heuristic. Throws Error if Embree cannot work (out of memory).
BuildTree buildSahTree(const std::vector<Box>& boxes, const BvhOptions& options);

/// Halves the triangles along the widest axis of their centres: as shallow as can be, whatever the input.
BuildTree buildBalancedTree(const std::vector<Box>& boxes, const BvhOptions& options);

/// Joins binary nodes to nodes of shared::kBvhWidth children with quantised boxes, depth first.
Bvh layoutTree(const BuildTree& tree);

}  // namespace manylight
