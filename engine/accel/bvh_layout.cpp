#include "engine/accel/build_tree.h"
#include "engine/core/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace manylight {

namespace {

/// One axis of a node: where its 256 planes are, and those that bound the children, a byte each.
struct QuantisedAxis {
    float origin = 0.0f;
    uint32_t exponent = 127;  // biased; 256 steps are 2^(exponent - 127)
    uint32_t lower = 0;
    uint32_t upper = 0;
};

float roundedDown(double x) {
    const auto rounded = static_cast<float>(x);
    return rounded > x ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}

/// Sets the plane numbers of [lower, upper] in byte `slot`, with room for the rounding of the slab test, which forms
/// (1 + q / 256) * (size / d) + (origin - o) / d: its error beyond a relative one is under 4 * 2^-24 * 2 * size.
/// False if the frame is too small.
bool quantise(double lower, double upper, size_t slot, QuantisedAxis& axis) {
    const double size = std::ldexp(1.0, static_cast<int>(axis.exponent) - 127);
    const double margin = size * 0x1p-18;
    const double q0 = std::floor(((lower - margin - double{axis.origin}) / size - 1.0) * 256.0);
    const double q1 = std::ceil(((upper + margin - double{axis.origin}) / size - 1.0) * 256.0);
    if (q0 < 0.0 || q1 > 255.0) return false;
    const size_t shift = 8 * slot;
    axis.lower |= static_cast<uint32_t>(q0) << shift;
    axis.upper |= static_cast<uint32_t>(q1) << shift;
    return true;
}

QuantisedAxis quantiseAxis(std::span<const Box> boxes, int axis) {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -lower;
    for (const Box& box : boxes) {
        lower = std::min(lower, double{box.lower[axis]});
        upper = std::max(upper, double{box.upper[axis]});
    }
    // The frame must not vanish beside the coordinates, which are floats.
    const double magnitude = std::max(std::abs(lower), std::abs(upper));
    const double smallestSize = std::max({upper - lower, magnitude * 0x1p-15, 0x1p-100});
    int exponent = 0;
    std::frexp(smallestSize, &exponent);
    for (--exponent; exponent < 127; ++exponent) {
        QuantisedAxis quantised;
        quantised.origin = roundedDown(lower - std::ldexp(1.0 + 0x1p-17, exponent));
        quantised.exponent = static_cast<uint32_t>(exponent + 127);
        bool fits = true;
        for (size_t slot = 0; slot < boxes.size() && fits; ++slot)
            fits = quantise(double{boxes[slot].lower[axis]}, double{boxes[slot].upper[axis]}, slot, quantised);
        if (fits) return quantised;
    }
    MANYLIGHT_CHECK(false, "a box is not finite");
    return {};
}

shared::BvhNode encodeBoxes(std::span<const Box> boxes) {
    std::array<QuantisedAxis, 3> axes;
    if (!boxes.empty())
        for (int axis = 0; axis < 3; ++axis) axes[static_cast<size_t>(axis)] = quantiseAxis(boxes, axis);
    return {.origin = {axes[0].origin, axes[1].origin, axes[2].origin},
            .exponentsAndSlots = axes[0].exponent | axes[1].exponent << 8 | axes[2].exponent << 16,
            .lowerX = axes[0].lower,
            .upperX = axes[0].upper,
            .lowerY = axes[1].lower,
            .upperY = axes[1].upper,
            .lowerZ = axes[2].lower,
            .upperZ = axes[2].upper,
            .firstChildAndLeaves = 0,
            .firstTriangle = 0,
            .padding = glm::uvec4(0u)};
}

float halfArea(const Box& box) {
    const glm::vec3 size = box.upper - box.lower;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// A node of the BVH before it has its place: inner children first, then leaves of two triangles, then of one.
struct WideNode {
    std::vector<const BuildNode*> leaves;
    std::vector<WideNode> inner;  // the largest box first: there is an occluder likeliest
    Box box;
    uint32_t depth = 1;
    uint32_t putAside = 0;       // groups of siblings put aside at once, at most, in this order of children
    uint32_t leastPutAside = 0;  // likewise if everywhere the child that needs most comes last
};

/// The children of a wide node: starting from the node itself, the largest inner one is replaced by its own two, for as
/// long as there is room.
std::vector<const BuildNode*> wideChildren(const BuildTree& tree, const BuildNode& node) {
    std::vector<const BuildNode*> children{&node};
    const auto opensLater = [](const BuildNode* a, const BuildNode* b) {
        if ((a->count == 0) != (b->count == 0)) return b->count == 0;
        return halfArea(a->box) < halfArea(b->box);
    };
    while (children.size() < shared::kBvhWidth) {
        const auto largest = std::ranges::max_element(children, opensLater);
        if ((*largest)->count != 0) break;
        const auto [left, right] = (*largest)->children;
        *largest = &tree.nodes[left];
        children.push_back(&tree.nodes[right]);
    }
    return children;
}

WideNode widen(const BuildTree& tree, const BuildNode& node) {
    WideNode wide{.leaves = {}, .inner = {}, .box = node.box};
    for (const BuildNode* child : wideChildren(tree, node)) {
        if (child->count == 0)
            wide.inner.push_back(widen(tree, *child));
        else
            wide.leaves.push_back(child);
    }
    std::ranges::stable_sort(wide.leaves, std::ranges::greater{}, &BuildNode::count);
    std::ranges::stable_sort(wide.inner, std::ranges::greater{},
                             [](const WideNode& child) { return halfArea(child.box); });
    std::vector<uint32_t> least;
    for (size_t i = 0; i < wide.inner.size(); ++i) {
        const uint32_t own = i + 1 < wide.inner.size() ? 1 : 0;  // the last has no siblings left
        wide.depth = std::max(wide.depth, wide.inner[i].depth + 1);
        wide.putAside = std::max(wide.putAside, wide.inner[i].putAside + own);
        least.push_back(wide.inner[i].leastPutAside);
    }
    std::ranges::sort(least);
    for (size_t i = 0; i < least.size(); ++i)
        wide.leastPutAside = std::max(wide.leastPutAside, least[i] + (i + 1 < least.size() ? 1 : 0));
    return wide;
}

class Layout {
  public:
    Bvh build(const BuildTree& tree) {
        bvh_.nodes.resize(1);
        bvh_.depth = 1;
        if (tree.nodes.empty()) {
            bvh_.nodes[0] = encodeBoxes({});
            return std::move(bvh_);
        }
        WideNode root = widen(tree, tree.nodes[0]);
        bvh_.depth = root.depth;
        bvh_.putAside = std::max(root.leastPutAside, std::min(root.putAside, shared::kBvhShortStackSize));
        triangles_ = tree.order;
        place(root, 0, bvh_.putAside);
        MANYLIGHT_CHECK(bvh_.nodes.size() <= size_t{1} << 24, "nodes of the BVH");
        return std::move(bvh_);
    }

  private:
    void placeLeaf(const BuildNode& leaf) {
        MANYLIGHT_CHECK(leaf.count <= shared::kBvhMaxLeafSize, "triangles of a leaf");
        const auto begin = triangles_.begin() + leaf.first;
        bvh_.triangleOrder.insert(bvh_.triangleOrder.end(), begin, begin + leaf.count);
    }

    /// `room`: groups of siblings that a traversal can still put aside.
    void place(WideNode& wide, uint32_t index, uint32_t room) {
        if (wide.putAside > room) std::ranges::stable_sort(wide.inner, std::ranges::less{}, &WideNode::leastPutAside);
        std::vector<Box> boxes;
        for (const WideNode& child : wide.inner) boxes.push_back(child.box);
        for (const BuildNode* leaf : wide.leaves) boxes.push_back(leaf->box);
        const auto innerCount = static_cast<uint32_t>(wide.inner.size());
        const auto pairCount = static_cast<uint32_t>(std::ranges::count(wide.leaves, 2u, &BuildNode::count));
        shared::BvhNode node = encodeBoxes(boxes);
        node.exponentsAndSlots |= ((1u << innerCount) - 1u) << 24 | (innerCount + pairCount) << 28;
        const auto firstChild = static_cast<uint32_t>(bvh_.nodes.size());
        node.firstChildAndLeaves = firstChild | ((1u << wide.leaves.size()) - 1u) << (24 + innerCount);
        node.firstTriangle = static_cast<uint32_t>(bvh_.triangleOrder.size()) - 2 * innerCount;
        bvh_.nodes[index] = node;
        bvh_.nodes.resize(bvh_.nodes.size() + innerCount);
        for (const BuildNode* leaf : wide.leaves) placeLeaf(*leaf);
        for (uint32_t slot = 0; slot < innerCount; ++slot)
            place(wide.inner[slot], firstChild + slot, slot + 1 < innerCount ? room - 1 : room);
    }

    std::vector<uint32_t> triangles_;  // in the leaf order of the binary tree
    Bvh bvh_;
};

}  // namespace

Bvh layoutTree(const BuildTree& tree) { return Layout().build(tree); }

}  // namespace manylight
