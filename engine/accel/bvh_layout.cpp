#include "engine/accel/build_tree.h"
#include "engine/core/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace manylight {

namespace {

/// One axis of a node: where its 256 planes are, and the four that bound the children.
struct QuantisedAxis {
    float origin = 0.0f;
    uint32_t exponent = 127;  // biased; 256 steps are 2^(exponent - 127)
    uint32_t planes = 0;
};

constexpr uint32_t kAbsentChildPlanes = 0x0000ffffu;  // both lower planes 255, both upper planes 0

float roundedDown(double x) {
    const auto rounded = static_cast<float>(x);
    return rounded > x ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}

/// Plane numbers of [lower, upper] with room for the rounding of the slab test, which forms
/// (1 + q / 256) * (size / d) + (origin - o) / d: its error beyond a relative one is under 4 * 2^-24 * 2 * size.
bool quantise(double lower, double upper, double origin, double size, uint32_t& lowerPlane, uint32_t& upperPlane) {
    const double margin = size * 0x1p-18;
    const double q0 = std::floor(((lower - margin - origin) / size - 1.0) * 256.0);
    const double q1 = std::ceil(((upper + margin - origin) / size - 1.0) * 256.0);
    if (q0 < 0.0 || q1 > 255.0) return false;
    lowerPlane = static_cast<uint32_t>(q0);
    upperPlane = static_cast<uint32_t>(q1);
    return true;
}

QuantisedAxis quantiseAxis(double leftLower, double leftUpper, double rightLower, double rightUpper) {
    const double lower = std::min(leftLower, rightLower);
    const double upper = std::max(leftUpper, rightUpper);
    // The frame must not vanish beside the coordinates, which are floats.
    const double magnitude = std::max(std::abs(lower), std::abs(upper));
    const double smallestSize = std::max({upper - lower, magnitude * 0x1p-15, 0x1p-100});
    int exponent = 0;
    std::frexp(smallestSize, &exponent);
    for (--exponent; exponent < 127; ++exponent) {
        const double size = std::ldexp(1.0, exponent);
        const float origin = roundedDown(lower - size * (1.0 + 0x1p-17));
        std::array<uint32_t, 4> q{};
        if (!quantise(leftLower, leftUpper, origin, size, q[0], q[2])) continue;
        if (!quantise(rightLower, rightUpper, origin, size, q[1], q[3])) continue;
        return {origin, static_cast<uint32_t>(exponent + 127), q[0] | q[1] << 8 | q[2] << 16 | q[3] << 24};
    }
    MANYLIGHT_CHECK(false, "a box is not finite");
    return {};
}

/// `right` may be absent: then its box is one that no ray enters.
shared::BvhNode encodeBoxes(const Box& left, const Box* right) {
    std::array<QuantisedAxis, 3> axes;
    for (int axis = 0; axis < 3; ++axis) {
        const Box& other = right ? *right : left;
        QuantisedAxis& encoded = axes[static_cast<size_t>(axis)];
        encoded = quantiseAxis(left.lower[axis], left.upper[axis], other.lower[axis], other.upper[axis]);
        if (!right) encoded.planes = (encoded.planes & 0x00ff00ffu) | (kAbsentChildPlanes & 0xff00ff00u);
    }
    shared::BvhNode node{};
    node.origin = {axes[0].origin, axes[1].origin, axes[2].origin};
    node.exponentsAndCounts = axes[0].exponent | axes[1].exponent << 8 | axes[2].exponent << 16;
    node.planesX = axes[0].planes;
    node.planesY = axes[1].planes;
    node.planesZ = axes[2].planes;
    return node;
}

shared::BvhNode emptyRoot() {
    shared::BvhNode node{};
    node.exponentsAndCounts = 127u | 127u << 8 | 127u << 16;
    node.planesX = node.planesY = node.planesZ = kAbsentChildPlanes;
    return node;
}

class Layout {
  public:
    explicit Layout(const BuildTree& tree) : tree_(tree) {}

    Bvh build() {
        if (tree_.nodes.empty()) {
            bvh_.nodes.push_back(emptyRoot());
        } else if (tree_.nodes[0].count != 0) {
            bvh_.nodes.push_back(encodeBoxes(tree_.nodes[0].box, nullptr));
            bvh_.nodes[0].exponentsAndCounts |= tree_.nodes[0].count << 24;
            placeLeaf(tree_.nodes[0]);
        } else {
            placeInner(tree_.nodes[0]);
        }
        bvh_.depth = treeDepth(tree_);
        return std::move(bvh_);
    }

  private:
    uint32_t placeLeaf(const BuildNode& leaf) {
        MANYLIGHT_CHECK(leaf.count <= shared::kBvhMaxLeafSize, "triangles of a leaf");
        const auto first = static_cast<uint32_t>(bvh_.triangleOrder.size());
        const auto begin = tree_.order.begin() + leaf.first;
        bvh_.triangleOrder.insert(bvh_.triangleOrder.end(), begin, begin + leaf.count);
        return first;
    }

    uint32_t placeInner(const BuildNode& inner) {
        const BuildNode& left = tree_.nodes[inner.children[0]];
        const BuildNode& right = tree_.nodes[inner.children[1]];
        const auto index = static_cast<uint32_t>(bvh_.nodes.size());
        shared::BvhNode node = encodeBoxes(left.box, &right.box);
        node.exponentsAndCounts |= left.count << 24 | right.count << 28;
        bvh_.nodes.push_back(node);
        // Leaves first: a leaf's triangles are named by `index`, an inner sibling is the next node.
        uint32_t reference = 0;
        if (left.count != 0) reference = placeLeaf(left);
        if (right.count != 0) {
            const uint32_t first = placeLeaf(right);
            if (left.count == 0) reference = first;
        }
        if (left.count == 0) placeInner(left);
        if (right.count == 0) {
            const uint32_t child = placeInner(right);
            if (left.count == 0) reference = child;
        }
        bvh_.nodes[index].index = reference;
        return index;
    }

    const BuildTree& tree_;
    Bvh bvh_;
};

}  // namespace

Bvh layoutTree(const BuildTree& tree) { return Layout(tree).build(); }

}  // namespace manylight
