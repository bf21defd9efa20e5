// A tree as deep as it has levels, which no builder would make of its triangles but which some input could lead to.
#pragma once

#include "engine/accel/build_tree.h"
#include "tests/unit/bvh_scenes.h"

namespace manylight::test {

struct Comb {
    Scene scene;
    BuildTree tree;
};

/// Level k has two triangles that are 0.9 times as large and as far from the origin as those of level k - 1. An inner
/// node has those of its level on one side and all further levels on the other.
inline Comb makeComb(uint32_t levels) {
    Comb comb;
    std::mt19937 random(12);
    float size = 0.5f;
    for (uint32_t level = 0; level < levels; ++level, size *= 0.9f) {
        for (int side = 0; side < 2; ++side) {
            const glm::vec3 center = size * randomPoint(random);
            addTriangle(comb.scene, center + 0.3f * size * randomPoint(random),
                        center + 0.3f * size * randomPoint(random), center + 0.3f * size * randomPoint(random));
        }
    }
    const std::vector<Box> boxes = triangleBoxes(comb.scene);
    std::vector<BuildNode>& nodes = comb.tree.nodes;
    for (uint32_t level = 0; level < levels; ++level) {
        // Spine, pair, leaf, leaf; the next spine follows.
        const auto spine = static_cast<uint32_t>(nodes.size());
        const Box pair = merge(boxes[2 * level], boxes[2 * level + 1]);
        if (level + 1 < levels) nodes.push_back({{}, {spine + 1, spine + 4}, 0, 0});
        const auto pairNode = static_cast<uint32_t>(nodes.size());
        nodes.push_back({pair, {pairNode + 1, pairNode + 2}, 0, 0});
        for (uint32_t triangle = 2 * level; triangle < 2 * level + 2; ++triangle) {
            nodes.push_back({boxes[triangle], {}, triangle, 1});
            comb.tree.order.push_back(triangle);
        }
    }
    for (size_t i = nodes.size(); i-- > 0;)
        if (nodes[i].count == 0) nodes[i].box = merge(nodes[nodes[i].children[0]].box, nodes[nodes[i].children[1]].box);
    return comb;
}

}  // namespace manylight::test
