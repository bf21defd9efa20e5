#include "engine/accel/build_tree.h"
#include "engine/accel/bvh.h"
#include "shaders/shared/packing.h"
#include "tests/unit/bvh_comb.h"
#include "tests/unit/bvh_scenes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>

namespace manylight {
namespace {

struct PlaneBox {
    glm::dvec3 lower{0.0};
    glm::dvec3 upper{0.0};
};

PlaneBox childBox(const shared::BvhNode& node, uint32_t slot) {
    const std::array<uint32_t, 3> lower{node.lowerX, node.lowerY, node.lowerZ};
    const std::array<uint32_t, 3> upper{node.upperX, node.upperY, node.upperZ};
    PlaneBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const int exponent = static_cast<int>(node.exponentsAndSlots >> (8 * axis) & 255u) - 127;
        const auto plane = [&](uint32_t planes) {
            const double q = planes >> (8 * slot) & 255u;
            return static_cast<double>(node.origin[axis]) + std::ldexp(1.0 + q / 256.0, exponent);
        };
        box.lower[axis] = plane(lower[static_cast<size_t>(axis)]);
        box.upper[axis] = plane(upper[static_cast<size_t>(axis)]);
    }
    return box;
}

/// Walks the whole BVH, checks every box against the triangles below it, and counts what it meets.
class Walk {
  public:
    Walk(const Scene& scene, const Bvh& bvh) : scene_(scene), bvh_(bvh), seen_(bvh.triangleOrder.size(), 0) {
        nodeVisits_ = 1;
        visit(0, {}, 1, 0);
    }

    void expectComplete() const {
        EXPECT_EQ(escapes_, 0u) << "corners outside a box above them";
        EXPECT_EQ(nodeVisits_, bvh_.nodes.size());
        EXPECT_EQ(deepest_, bvh_.depth);
        EXPECT_LT(bvh_.depth, static_cast<uint32_t>(shared::kBvhStackSize));
        EXPECT_LE(mostPutAside_, bvh_.putAside);
        EXPECT_LE(bvh_.putAside, shared::kBvhShortStackSize);
        for (const uint32_t times : seen_) ASSERT_EQ(times, 1u);
        std::vector<uint32_t> order = bvh_.triangleOrder;
        std::ranges::sort(order);
        ASSERT_EQ(order.size(), scene_.triangles.size());
        for (uint32_t i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], i);
    }

  private:
    void visit(uint32_t index, const std::vector<PlaneBox>& above, uint32_t depth, uint32_t putAside) {
        deepest_ = std::max(deepest_, depth);
        mostPutAside_ = std::max(mostPutAside_, putAside);
        const shared::BvhNode& node = bvh_.nodes[index];
        const uint32_t innerSlots = node.exponentsAndSlots >> 24 & 15u;
        const uint32_t innerCount = static_cast<uint32_t>(std::popcount(innerSlots));
        EXPECT_EQ(innerSlots, (1u << innerCount) - 1u) << "inner children come first";
        const uint32_t singlesStart = node.exponentsAndSlots >> 28;
        for (uint32_t slot = 0; slot < shared::kBvhWidth; ++slot) {
            std::vector<PlaneBox> boxes = above;
            boxes.push_back(childBox(node, slot));
            const bool isLeaf = (node.firstChildAndLeaves >> (24 + slot) & 1u) != 0;
            EXPECT_FALSE(isLeaf && slot < innerCount);
            if (slot < innerCount) {
                ++nodeVisits_;
                visit((node.firstChildAndLeaves & 0xffffffu) + slot, boxes, depth + 1,
                      putAside + (slot + 1 < innerCount ? 1 : 0));
            } else if (isLeaf) {
                visitLeaf(node.firstTriangle + slot + std::min(slot, singlesStart), slot < singlesStart ? 2 : 1, boxes);
            }
        }
    }

    void visitLeaf(uint32_t first, uint32_t count, const std::vector<PlaneBox>& boxes) {
        for (uint32_t i = first; i < first + count; ++i) {
            ASSERT_LT(i, seen_.size());
            ++seen_[i];
            for (const uint32_t vertex : scene_.triangles[bvh_.triangleOrder[i]].vertex) {
                const glm::dvec3 p = scene_.vertices[vertex].position;
                for (const PlaneBox& box : boxes) {
                    const bool inside =
                        glm::all(glm::greaterThan(p, box.lower)) && glm::all(glm::lessThan(p, box.upper));
                    escapes_ += inside ? 0 : 1;
                }
            }
        }
    }

    const Scene& scene_;
    const Bvh& bvh_;
    std::vector<uint32_t> seen_;
    uint64_t escapes_ = 0;
    uint32_t nodeVisits_ = 0;
    uint32_t deepest_ = 0;
    uint32_t mostPutAside_ = 0;
};

void expectSound(const Scene& scene) {
    const Bvh bvh = buildBvh(scene);
    Walk(scene, bvh).expectComplete();
}

TEST(BvhBuild, HoldsEveryTriangleOnceInsideItsBoxes) {
    expectSound(test::triangleSoup(5000, 0.1f, 1));
    expectSound(test::triangleSoup(500, 2.0f, 2));
    expectSound(test::closedBox(12));
    expectSound(test::closedBox(12, 0.5f));
}

TEST(BvhBuild, EveryLeafSizeWorks) {
    const Scene scene = test::triangleSoup(999, 0.2f, 3);
    for (uint32_t size = 1; size <= shared::kBvhMaxLeafSize; ++size) {
        const Bvh bvh = buildBvh(scene, {.maxLeafSize = size});
        Walk(scene, bvh).expectComplete();
    }
}

TEST(BvhBuild, AFewTrianglesAreEnough) {
    for (uint32_t count = 1; count <= 9; ++count) expectSound(test::triangleSoup(count, 0.5f, count));
}

TEST(BvhBuild, NoTriangleIsOneNodeWithoutChildren) {
    const Bvh bvh = buildBvh(Scene{});
    ASSERT_EQ(bvh.nodes.size(), 1u);
    EXPECT_TRUE(bvh.triangleOrder.empty());
    EXPECT_EQ(bvh.nodes[0].exponentsAndSlots >> 24 & 15u, 0u);
    EXPECT_EQ(bvh.nodes[0].firstChildAndLeaves >> 24, 0u);
    EXPECT_TRUE(packTriangles(Scene{}, bvh).empty());
}

TEST(BvhBuild, EqualCentersAndFlatBoxesEnd) {
    Scene identical;
    for (int i = 0; i < 5000; ++i) test::addTriangle(identical, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    expectSound(identical);

    Scene concentric;
    for (int i = 1; i <= 3000; ++i) {
        const float r = static_cast<float>(i) * 1e-4f;
        test::addTriangle(concentric, {-r, -r, -r}, {r, r, r}, {r, -r, 0});
    }
    expectSound(concentric);
}

TEST(BvhBuild, ExtremeSizesStayInTheirBoxes) {
    Scene scene;
    for (int k = 0; k < 120; ++k) {  // each half the size of the last, down to 2^-120
        const float r = std::ldexp(0.5f, -k);
        test::addTriangle(scene, {r, 0, 0}, {r * 1.5f, 0, 0}, {r, r * 0.25f, 0});
        test::addTriangle(scene, {0.5f, r, 0.25f}, {0.5f, r, 0.25f}, {0.5f, r, 0.25f});  // a point
    }
    test::addTriangle(scene, {0.3f, 0.3f, 0.3f}, {0.3f + 2e-4f, 0.3f, 0.3f}, {0.3f, 0.3f + 2e-4f, 0.3f});
    test::addTriangle(scene, {-0.5f, 0.1f, 0.1f}, {0.5f, 0.1f, 0.1f}, {0.0f, 0.1f + 1e-6f, 0.1f});
    expectSound(scene);
}

TEST(BvhBuild, TheSameTrianglesGiveTheSameBytes) {
    for (const Scene& scene : {test::triangleSoup(20000, 0.05f, 4), test::closedBox(40)}) {
        const Bvh first = buildBvh(scene);
        for (int run = 0; run < 3; ++run) {
            const Bvh again = buildBvh(scene);
            ASSERT_EQ(first.nodes.size(), again.nodes.size());
            EXPECT_EQ(std::memcmp(first.nodes.data(), again.nodes.data(), first.nodes.size() * sizeof(shared::BvhNode)),
                      0);
            EXPECT_EQ(first.triangleOrder, again.triangleOrder);
        }
    }
}

TEST(BvhBuild, TheShallowTreeIsSoundAndShallow) {
    const Scene scene = test::triangleSoup(4096, 0.1f, 5);
    const Bvh bvh = layoutTree(buildBalancedTree(triangleBoxes(scene), {.maxLeafSize = 2}));
    Walk(scene, bvh).expectComplete();
    EXPECT_EQ(bvh.depth, 6u);  // 4096 / 2 leaves, four times as many with every level
}

TEST(BvhBuild, TheLargestInnerChildComesFirst) {
    const Bvh bvh = buildBvh(test::triangleSoup(5000, 0.1f, 10));
    for (const shared::BvhNode& node : bvh.nodes) {
        const auto area = [&](uint32_t slot) {
            const PlaneBox box = childBox(node, slot);
            const glm::dvec3 size = box.upper - box.lower;
            return size.x * size.y + size.y * size.z + size.z * size.x;
        };
        const uint32_t innerCount = static_cast<uint32_t>(std::popcount(node.exponentsAndSlots >> 24 & 15u));
        for (uint32_t slot = 1; slot < innerCount; ++slot) ASSERT_LE(area(slot), 1.1 * area(slot - 1));
    }
}

TEST(BvhBuild, ADeepTreeNeedsNoDeepStack) {
    const test::Comb comb = test::makeComb(60);
    const Bvh bvh = layoutTree(comb.tree);
    EXPECT_GE(bvh.depth, 20u);
    EXPECT_EQ(bvh.putAside, shared::kBvhShortStackSize);  // the largest child comes last in the upper nodes only
    Walk(comb.scene, bvh).expectComplete();
}

TEST(BvhBuild, FitsTheMemoryBudget) {
    for (const Scene& scene : {test::triangleSoup(20000, 0.05f, 6), test::closedBox(60)}) {
        const Bvh bvh = buildBvh(scene);
        const size_t triangles = scene.triangles.size();
        const size_t bytes = bvh.nodes.size() * sizeof(shared::BvhNode) + triangles * (48 + 4 + 24);
        EXPECT_LE(bytes, 128 * triangles);
    }
}

TEST(TriangleRecord, KeepsThePositionsBitsAndTheNormals) {
    Scene scene = test::triangleSoup(100, 0.3f, 7);
    std::mt19937 random(8);
    for (size_t i = 0; i < 30; ++i) scene.vertices[i].normal = glm::normalize(test::randomPoint(random));
    scene.vertices[29].normal = glm::vec3(0.0f);  // the tenth triangle has only two normals: flat
    const Bvh bvh = buildBvh(scene);
    const std::vector<glm::vec4> corners = packTriangles(scene, bvh);
    ASSERT_EQ(corners.size(), 300u);
    for (size_t i = 0; i < corners.size(); ++i) {
        const uint32_t triangle = bvh.triangleOrder[i / 3];
        const Vertex& vertex = scene.vertices[scene.triangles[triangle].vertex[i % 3]];
        EXPECT_EQ(std::memcmp(&corners[i], &vertex.position, sizeof(glm::vec3)), 0);
        uint32_t bits = 0;
        std::memcpy(&bits, &corners[i].w, sizeof(bits));
        if (triangle >= 9) {
            EXPECT_EQ(bits, shared::kNoNormal);
        } else {
            EXPECT_LT(glm::distance(shared::unpackUnitVector(bits), vertex.normal), 1e-4f);
        }
    }
}

TEST(Packing, UnitVectorsSurvive) {
    std::mt19937 random(9);
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 direction = glm::normalize(test::randomPoint(random));
        const uint32_t bits = shared::packUnitVector(direction);
        ASSERT_NE(bits, shared::kNoNormal);
        ASSERT_LT(glm::distance(shared::unpackUnitVector(bits), direction), 1e-4f);
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {-1.0f, 1.0f}) {
            glm::vec3 direction{0.0f};
            direction[axis] = sign;
            EXPECT_EQ(shared::unpackUnitVector(shared::packUnitVector(direction)), direction);
        }
    }
}

}  // namespace
}  // namespace manylight
