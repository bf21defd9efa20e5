#include "engine/accel/build_tree.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace manylight {

Box merge(const Box& a, const Box& b) { return {glm::min(a.lower, b.lower), glm::max(a.upper, b.upper)}; }

std::vector<Box> triangleBoxes(const Scene& scene) {
    std::vector<Box> boxes;
    boxes.reserve(scene.triangles.size());
    for (const Triangle& triangle : scene.triangles) {
        const glm::vec3& a = scene.vertices[triangle.vertex[0]].position;
        const glm::vec3& b = scene.vertices[triangle.vertex[1]].position;
        const glm::vec3& c = scene.vertices[triangle.vertex[2]].position;
        boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
    }
    return boxes;
}

namespace {

glm::vec3 center(const Box& box) { return 0.5f * box.lower + 0.5f * box.upper; }

int widestAxisOfCenters(const std::vector<Box>& boxes, std::span<const uint32_t> triangles) {
    glm::vec3 lower = center(boxes[triangles[0]]);
    glm::vec3 upper = lower;
    for (const uint32_t triangle : triangles) {
        lower = glm::min(lower, center(boxes[triangle]));
        upper = glm::max(upper, center(boxes[triangle]));
    }
    const glm::vec3 extent = upper - lower;
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
}

uint32_t buildHalves(BuildTree& tree, const std::vector<Box>& boxes, uint32_t first, uint32_t count,
                     uint32_t maxLeafSize) {
    const auto index = static_cast<uint32_t>(tree.nodes.size());
    tree.nodes.emplace_back();
    const std::span<uint32_t> triangles(tree.order.data() + first, count);
    if (count <= maxLeafSize) {
        std::ranges::sort(triangles);
        Box box = boxes[triangles[0]];
        for (const uint32_t triangle : triangles) box = merge(box, boxes[triangle]);
        tree.nodes[index] = {box, {}, first, count};
        return index;
    }
    const int axis = widestAxisOfCenters(boxes, triangles);
    const uint32_t half = count / 2;
    std::ranges::nth_element(triangles, triangles.begin() + half, [&](uint32_t a, uint32_t b) {
        const float centerA = center(boxes[a])[axis];
        const float centerB = center(boxes[b])[axis];
        return centerA != centerB ? centerA < centerB : a < b;
    });
    const uint32_t left = buildHalves(tree, boxes, first, half, maxLeafSize);
    const uint32_t right = buildHalves(tree, boxes, first + half, count - half, maxLeafSize);
    tree.nodes[index] = {merge(tree.nodes[left].box, tree.nodes[right].box), {left, right}, 0, 0};
    return index;
}

}  // namespace

BuildTree buildBalancedTree(const std::vector<Box>& boxes, const BvhOptions& options) {
    BuildTree tree;
    if (boxes.empty()) return tree;
    tree.order.resize(boxes.size());
    std::iota(tree.order.begin(), tree.order.end(), 0u);
    buildHalves(tree, boxes, 0, static_cast<uint32_t>(boxes.size()), options.maxLeafSize);
    return tree;
}

}  // namespace manylight
