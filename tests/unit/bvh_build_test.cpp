#include "engine/accel/build_tree.h"
#include "engine/accel/bvh.h"
#include "shaders/shared/packing.h"
#include "tests/unit/bvh_scenes.h"

#include <gtest/gtest.h>

#include <cstring>

namespace manylight {
namespace {

struct PlaneBox {
    glm::dvec3 lower{0.0};
    glm::dvec3 upper{0.0};
};

PlaneBox childBox(const shared::BvhNode& node, uint32_t child) {
    const std::array<uint32_t, 3> planes{node.planesX, node.planesY, node.planesZ};
    PlaneBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const int exponent = static_cast<int>(node.exponentsAndCounts >> (8 * axis) & 255u) - 127;
        const auto plane = [&](uint32_t byte) {
            const double q = planes[static_cast<size_t>(axis)] >> (8 * byte) & 255u;
            return static_cast<double>(node.origin[axis]) + std::ldexp(1.0 + q / 256.0, exponent);
        };
        box.lower[axis] = plane(child);
        box.upper[axis] = plane(child + 2);
    }
    return box;
}

/// Walks the whole BVH, checks its boxes against the triangles below them, and counts what it meets.
class Walk {
  public:
    Walk(const Scene& scene, const Bvh& bvh)
        : scene_(scene), bvh_(bvh), inLeaves_(bvh.triangleOrder.size(), 0), boxesOf_(scene.triangles.size()) {
        nodeVisits_ = 1;
        visit(0, kEverywhere, 1);
    }

    /// Every node and every copy is met once, every triangle is drawn once, and no part of it is outside of the boxes.
    void expectComplete() const {
        EXPECT_EQ(nodeVisits_, bvh_.nodes.size());
        EXPECT_EQ(deepest_, bvh_.depth);
        EXPECT_LT(bvh_.depth, static_cast<uint32_t>(shared::kBvhStackSize));
        ASSERT_GE(bvh_.triangleOrder.size(), scene_.triangles.size());
        std::vector<uint32_t> drawn(bvh_.triangleOrder.begin(),
                                    bvh_.triangleOrder.begin() + static_cast<ptrdiff_t>(scene_.triangles.size()));
        std::ranges::sort(drawn);
        for (uint32_t i = 0; i < drawn.size(); ++i) {
            ASSERT_EQ(drawn[i], i);
            ASSERT_GT(boxesOf_[i].size(), 0u) << "triangle " << i << " is in no leaf";
            expectCovered(i);
        }
        for (size_t i = 0; i < inLeaves_.size(); ++i) ASSERT_LE(inLeaves_[i], 1u);
        for (size_t i = scene_.triangles.size(); i < inLeaves_.size(); ++i) ASSERT_EQ(inLeaves_[i], 1u);
    }

    uint64_t leafEntries() const { return static_cast<uint64_t>(std::ranges::count(inLeaves_, 1u)); }

  private:
    static constexpr PlaneBox kEverywhere{glm::dvec3(-1e300), glm::dvec3(1e300)};

    void visit(uint32_t index, const PlaneBox& above, uint32_t depth) {
        deepest_ = std::max(deepest_, depth);
        const shared::BvhNode& node = bvh_.nodes[index];
        const uint32_t leftCount = node.exponentsAndCounts >> 24 & 15u;
        const uint32_t rightCount = node.exponentsAndCounts >> 28;
        for (uint32_t child = 0; child < 2; ++child) {
            PlaneBox box = childBox(node, child);
            if (box.lower.x > box.upper.x) continue;
            box = {glm::max(box.lower, above.lower), glm::min(box.upper, above.upper)};
            const uint32_t count = child == 0 ? leftCount : rightCount;
            if (count != 0) {
                visitLeaf(child == 0 ? node.index : node.index + leftCount, count, box);
            } else {
                ++nodeVisits_;
                visit(child == 0 || leftCount != 0 ? index + 1 : node.index, box, depth + 1);
            }
        }
    }

    void visitLeaf(uint32_t first, uint32_t count, const PlaneBox& box) {
        for (uint32_t i = first; i < first + count; ++i) {
            ++inLeaves_[i];
            boxesOf_[bvh_.triangleOrder[i]].push_back(box);
        }
    }

    /// Corners, points on the edges and points inside are in the boxes of one of the triangle's leaves.
    void expectCovered(uint32_t triangle) const {
        constexpr int kSteps = 12;
        std::array<glm::dvec3, 3> corner;
        for (size_t i = 0; i < 3; ++i) corner[i] = scene_.vertices[scene_.triangles[triangle].vertex[i]].position;
        for (int a = 0; a <= kSteps; ++a) {
            for (int b = 0; a + b <= kSteps; ++b) {
                const double u = static_cast<double>(a) / kSteps;
                const double v = static_cast<double>(b) / kSteps;
                const glm::dvec3 p = (1.0 - u - v) * corner[0] + u * corner[1] + v * corner[2];
                ASSERT_TRUE(std::ranges::any_of(boxesOf_[triangle],
                                                [&](const PlaneBox& box) {
                                                    return glm::all(glm::greaterThan(p, box.lower)) &&
                                                           glm::all(glm::lessThan(p, box.upper));
                                                }))
                    << "triangle " << triangle << " at " << u << ", " << v;
            }
        }
    }

    const Scene& scene_;
    const Bvh& bvh_;
    std::vector<uint32_t> inLeaves_;              // per entry of the order
    std::vector<std::vector<PlaneBox>> boxesOf_;  // per triangle: what is left of the boxes above each of its leaves
    uint32_t nodeVisits_ = 0;
    uint32_t deepest_ = 0;
};

void expectSound(const Scene& scene) {
    const Bvh bvh = buildBvh(scene);
    Walk(scene, bvh).expectComplete();
}

TEST(BvhBuild, HoldsEveryTriangleInsideItsBoxes) {
    expectSound(test::triangleSoup(5000, 0.1f, 1));
    expectSound(test::triangleSoup(500, 2.0f, 2));
    expectSound(test::closedBox(12));
    expectSound(test::closedBox(12, 0.5f));
}

TEST(BvhBuild, WithoutBudgetNoTriangleIsSplit) {
    const Scene scene = test::triangleSoup(2000, 1.0f, 10);
    const Bvh bvh = buildBvh(scene, {.splitBudget = 0.0f});
    EXPECT_EQ(bvh.triangleOrder.size(), scene.triangles.size());
    Walk(scene, bvh).expectComplete();
}

/// Long thin triangles across each other, which no box fits.
Scene needles(uint32_t count) {
    std::mt19937 random(11);
    Scene scene;
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec3 a = test::randomPoint(random);
        test::addTriangle(scene, a, a + 0.002f * test::randomPoint(random), test::randomPoint(random));
    }
    return scene;
}

TEST(BvhBuild, LargeTrianglesAreSplitWithinTheBudget) {
    const Scene scene = needles(2000);
    for (const float budget : {0.05f, 0.1f}) {
        const Bvh bvh = buildBvh(scene, {.splitBudget = budget});
        const Walk walk(scene, bvh);
        walk.expectComplete();
        EXPECT_GT(walk.leafEntries(), scene.triangles.size());
        EXPECT_LE(static_cast<float>(walk.leafEntries()), (1.0f + budget) * 2000.0f);
        EXPECT_LE(static_cast<float>(bvh.triangleOrder.size()), (1.0f + kMaxBvhCopies) * 2000.0f);
    }
}

TEST(BvhBuild, TooManyCopiesAreNotMade) {
    const Scene scene = needles(2000);
    const Bvh bvh = buildBvh(scene, {.splitBudget = 2.0f});
    EXPECT_EQ(bvh.triangleOrder.size(), scene.triangles.size());
    Walk(scene, bvh).expectComplete();
}

TEST(BvhBuild, PartsOfATriangleCoverItAndMeetAtThePlane) {
    Scene scene;
    test::addTriangle(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0.5f});
    const Box whole{{0, 0, 0}, {1, 1, 0.5f}};
    const SplitBoxes parts = splitTriangle(scene, 0, whole, 0, 0.25f);
    EXPECT_EQ(parts.below.lower, whole.lower);
    EXPECT_EQ(parts.above.upper.x, 1.0f);
    EXPECT_EQ(parts.above.lower.y, 0.0f);
    EXPECT_NEAR(parts.below.upper.x, 0.25f, 2e-6f);
    EXPECT_NEAR(parts.above.lower.x, 0.25f, 2e-6f);
    EXPECT_GT(parts.below.upper.x, parts.above.lower.x);  // they overlap
    EXPECT_EQ(parts.below.upper.y, 1.0f);
    EXPECT_NEAR(parts.above.upper.y, 0.75f, 2e-6f);
    EXPECT_GT(parts.above.upper.y, 0.75f);
    EXPECT_NEAR(parts.above.upper.z, 0.375f, 2e-6f);
    // A plane beside the triangle: nothing is lost.
    const SplitBoxes beside = splitTriangle(scene, 0, {{0, 0, 0}, {2, 1, 1}}, 0, 1.5f);
    EXPECT_EQ(beside.above.lower.x, 1.5f);
    EXPECT_GT(beside.below.upper.x, 1.0f);
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

TEST(BvhBuild, NoTriangleIsOneNodeOfTwoAbsentChildren) {
    const Bvh bvh = buildBvh(Scene{});
    ASSERT_EQ(bvh.nodes.size(), 1u);
    EXPECT_TRUE(bvh.triangleOrder.empty());
    EXPECT_EQ(bvh.nodes[0].planesX & 0xffu, 255u);  // lower plane
    EXPECT_EQ(bvh.nodes[0].planesX >> 16 & 0xffu, 0u);
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
    for (const Scene& scene : {test::triangleSoup(20000, 0.05f, 4), test::closedBox(40), needles(5000)}) {
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
    const Bvh bvh = layoutTree(buildBalancedTree(triangleBoxes(scene), {.maxLeafSize = 4}), scene.triangles.size());
    Walk(scene, bvh).expectComplete();
    EXPECT_EQ(bvh.depth, 10u);  // 4096 / 4 leaves
}

TEST(BvhBuild, FitsTheMemoryBudget) {
    for (const Scene& scene : {test::triangleSoup(20000, 0.05f, 6), test::closedBox(60), needles(20000)}) {
        const Bvh bvh = buildBvh(scene);
        const size_t triangles = scene.triangles.size();
        const size_t bytes = bvh.nodes.size() * sizeof(shared::BvhNode) + bvh.triangleOrder.size() * (48 + 4 + 24);
        EXPECT_LE(bytes, 128 * triangles);
    }
}

TEST(TriangleRecord, KeepsThePositionsBitsAndTheNormals) {
    Scene scene = test::triangleSoup(100, 0.3f, 7);
    std::mt19937 random(8);
    for (size_t i = 0; i < 30; ++i) scene.vertices[i].normal = glm::normalize(test::randomPoint(random));
    scene.vertices[29].normal = glm::vec3(0.0f);  // the tenth triangle has only two normals: flat
    const Bvh bvh = buildBvh(scene, {.splitBudget = 0.0f});
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
