// The traversal of the shaders, compiled as C++, against testing every triangle and against Embree.
#include "engine/accel/build_tree.h"
#include "engine/accel/bvh.h"
#include "engine/accel/embree_reference.h"
#include "engine/accel/ray_sets.h"
#include "engine/gpu/tuning.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/bvh_ray.h"
#include "shaders/shared/instance.h"
#include "shaders/shared/ray_offset.h"
#include "shaders/shared/sobol.h"
#include "tests/unit/bvh_comb.h"
#include "tests/unit/bvh_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

namespace manylight::shared {
namespace {
struct TexelBuffer {
    const uvec4* texels = nullptr;
    int size = 0;
};
TexelBuffer bvhNodes;
TexelBuffer bvhTriangles;
// Specialisation constants in shaders.
bool kBvhStackInRegisters = true;
uint kBvhClosestRegisters = 0u;
int kMostNodesAny = 12;
int kMostNodesClosest = 8;
uvec4 imageLoad(const TexelBuffer& buffer, int index) {
    if (index < 0 || index >= buffer.size) throw std::out_of_range("imageLoad");
    return buffer.texels[index];
}

using glm::floatBitsToUint;
constexpr bool kAlphaTested = false;
constexpr uint kInstanced = 0;  // two levels are tested on the device
TexelBuffer instanceTexels;
using glm::dot;
#include "shaders/lib/bvh.glsl"
bool letsThrough(uint, vec2, uint) { return false; }
}  // namespace
}  // namespace manylight::shared

namespace manylight {
namespace {

using shared::RayQuery;

/// Binds a scene's buffers to the traversal for as long as it lives.
class Traversal {
  public:
    explicit Traversal(const Scene& scene) : Traversal(scene, buildBvh(scene)) {}
    Traversal(const Scene& scene, Bvh bvh) : bvh_(std::move(bvh)), corners_(packTriangles(scene, bvh_)) {
        static_assert(sizeof(shared::BvhNode) == shared::kBvhTexelsPerNode * sizeof(glm::uvec4));
        shared::bvhNodes.texels = reinterpret_cast<const glm::uvec4*>(bvh_.nodes.data());
        corners_.resize(std::max<size_t>(corners_.size(), 3));  // as on the device
        shared::bvhTriangles.texels = reinterpret_cast<const glm::uvec4*>(corners_.data());
        shared::bvhTriangles.size = static_cast<int>(corners_.size());
        shared::bvhNodes.size = static_cast<int>(bvh_.nodes.size()) * shared::kBvhTexelsPerNode;
        shared::bvhLoopBudgetExceeded = false;
    }
    ~Traversal() { EXPECT_FALSE(shared::bvhLoopBudgetExceeded); }
    Traversal(const Traversal&) = delete;
    Traversal& operator=(const Traversal&) = delete;

    shared::Hit closest(const RayQuery& ray) const {
        const auto isSame = [](const shared::Hit& a, const shared::Hit& b) {
            return a.t == b.t && a.triangle == b.triangle && a.barycentrics == b.barycentrics;
        };
        shared::kBvhClosestRegisters = 0;
        const shared::Hit byMemory = shared::closestHit(ray.origin, ray.direction, ray.tMax);
        shared::kBvhClosestRegisters = gpu::forTreesOfDepth({}, bvh_.depth).closestRegisters;
        const shared::Hit hit = shared::closestHit(ray.origin, ray.direction, ray.tMax);
        EXPECT_TRUE(isSame(hit, byMemory));
        return hit;
    }
    bool occluded(const RayQuery& ray) const {
        shared::kBvhStackInRegisters = false;
        shared::kMostNodesAny = 4;
        const bool byMemory = shared::occluded(ray.origin, ray.direction, ray.tMax);
        shared::kBvhStackInRegisters = true;
        shared::kMostNodesAny = 12;
        const bool byRegisters = shared::occluded(ray.origin, ray.direction, ray.tMax);
        EXPECT_EQ(byMemory, byRegisters);
        return byRegisters;
    }
    uint32_t sceneTriangle(const shared::Hit& hit) const { return bvh_.triangleOrder[hit.triangle]; }

    /// The same triangle test on all triangles, without boxes.
    shared::Hit bruteForce(const RayQuery& query) const {
        const shared::TraversalRay ray = shared::makeTraversalRay(query.origin, query.direction);
        shared::Hit best{query.tMax, shared::kNoHit, glm::vec2(0.0f)};
        if (query.direction == glm::vec3(0.0f)) return best;
        for (uint32_t i = 0; i < bvh_.triangleOrder.size(); ++i) {
            const shared::TriangleHit hit = shared::testTriangle(ray, i, query.tMax);
            if (hit.isHit && hit.t < best.t) best = {hit.t, i, hit.barycentrics};
        }
        return best;
    }

  private:
    Bvh bvh_;
    std::vector<glm::vec4> corners_;
};

void expectSameAsBruteForce(const Traversal& traversal, const std::vector<RayQuery>& rays) {
    for (const RayQuery& ray : rays) {
        const shared::Hit expected = traversal.bruteForce(ray);
        const shared::Hit hit = traversal.closest(ray);
        ASSERT_EQ(hit.triangle, expected.triangle)
            << ray.origin.x << " " << ray.origin.y << " " << ray.origin.z << " towards " << ray.direction.x << " "
            << ray.direction.y << " " << ray.direction.z;
        if (hit.triangle != shared::kNoHit) {
            ASSERT_EQ(hit.t, expected.t);
        }
        ASSERT_EQ(traversal.occluded(ray), expected.triangle != shared::kNoHit);
    }
}

void expectSameAsBruteForce(const Scene& scene, const std::vector<RayQuery>& rays) {
    expectSameAsBruteForce(Traversal(scene), rays);
}

TEST(BvhTraverse, RandomRaysFindWhatTestingAllTrianglesFinds) {
    const std::vector<RayQuery> rays = test::randomRays(5000, 1);
    expectSameAsBruteForce(test::triangleSoup(1000, 0.2f, 1), rays);
    expectSameAsBruteForce(test::triangleSoup(300, 1.5f, 2), rays);
    expectSameAsBruteForce(test::closedBox(6, 0.5f), rays);
}

TEST(BvhTraverse, AxisAlignedRaysAndSignedZeros) {
    const std::vector<RayQuery> rays = test::signedZeroRays();
    expectSameAsBruteForce(test::closedBox(4), rays);
    expectSameAsBruteForce(test::closedBox(3), rays);
    expectSameAsBruteForce(test::triangleSoup(400, 0.5f, 3), rays);
}

TEST(BvhTraverse, RaysFromAfarAndToAfar) {
    std::vector<RayQuery> rays = test::randomRays(3000, 4);
    for (size_t i = 0; i < rays.size(); ++i) {
        const float distance = std::ldexp(1.0f, static_cast<int>(i % 20));
        const glm::vec3 target = rays[i].origin;
        rays[i].origin = target - distance * glm::normalize(rays[i].direction);
        rays[i].direction = target - rays[i].origin;
        rays[i].tMax = 1e10f;
    }
    expectSameAsBruteForce(test::triangleSoup(1000, 0.2f, 5), rays);
    expectSameAsBruteForce(test::closedBox(5), rays);
}

TEST(BvhTraverse, NoTriangleNoHit) {
    const Traversal traversal(Scene{});
    for (const RayQuery& ray : test::signedZeroRays()) {
        ASSERT_FALSE(traversal.occluded(ray));
        ASSERT_EQ(traversal.closest(ray).triangle, shared::kNoHit);
    }
}

TEST(BvhTraverse, AFewTriangles) {
    for (uint32_t count = 1; count <= 9; ++count) {
        expectSameAsBruteForce(test::triangleSoup(count, 1.5f, count), test::randomRays(500, count));
    }
}

/// Every second ray runs through most boxes of the comb, the others at a triangle.
std::vector<RayQuery> raysThrough(const test::Comb& comb, uint32_t count) {
    std::vector<RayQuery> rays = test::randomRays(count, 13);
    for (size_t i = 0; i < rays.size(); ++i) {
        const glm::vec3& corner = comb.scene.vertices[i % comb.scene.vertices.size()].position;
        const glm::vec3& next = comb.scene.vertices[(i + 1) % comb.scene.vertices.size()].position;
        if (i % 2 == 0) rays[i].origin = glm::vec3(1.0f, 0.3f, 0.1f) * rays[i].origin;
        rays[i].direction = (i % 2 == 0 ? glm::vec3(0.0f) : 0.5f * corner + 0.5f * next) - rays[i].origin;
        rays[i].tMax = 1e10f;
    }
    return rays;
}

TEST(BvhTraverse, DeepTreesDoNotOverflowTheStacks) {
    const test::Comb comb = test::makeComb(60);
    expectSameAsBruteForce(Traversal(comb.scene, layoutTree(comb.tree)), raysThrough(comb, 20000));
}

// Registers are enough for the deepest trees that closest-hit queries are let use them for, twelve or sixteen of them.
TEST(BvhTraverse, TreesOfEveryDepth) {
    std::map<uint32_t, uint32_t> deepest;  // by the number of registers
    for (uint32_t levels = 2; levels < 60; levels += 2) {
        const test::Comb comb = test::makeComb(levels);
        Bvh bvh = layoutTree(comb.tree);
        deepest[gpu::forTreesOfDepth({}, bvh.depth).closestRegisters] = bvh.depth;
        expectSameAsBruteForce(Traversal(comb.scene, std::move(bvh)), raysThrough(comb, 2000));
    }
    EXPECT_EQ(deepest.size(), 3u);
    for (const uint32_t registers : {shared::kBvhShortStackSize, shared::kBvhRegisterStackSize})
        EXPECT_EQ(deepest[registers], registers + 1);
}

TEST(BvhTraverse, QueuesAreInOrderOfDistance) {
    shared::NodeVisit visit{};
    visit.firstChild = 1000;
    visit.entry = glm::ivec4(64, 0, 128, 32);
    visit.innerSlots = 15;
    shared::NearestFirst order = shared::nearestFirst(visit);
    EXPECT_EQ(order.nearest, 1001u);
    for (const uint32_t expected : {1003u, 1000u, 1002u}) {
        ASSERT_NE(shared::queueLength(order.others), 0u);
        EXPECT_EQ(shared::queueFront(order.others), expected);
        order.others = shared::withoutFront(order.others);
    }
    EXPECT_EQ(shared::queueLength(order.others), 0u);
    visit.innerSlots = 4;
    order = shared::nearestFirst(visit);
    EXPECT_EQ(order.nearest, 1002u);
    EXPECT_EQ(shared::queueLength(order.others), 0u);
}

TEST(BvhTraverse, ZeroDirectionsAndNaNMiss) {
    const Traversal traversal(test::closedBox(4));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(traversal.occluded({{0, 0, 0.5f}, 1e10f, {0, 0, 0}, 0}));
    EXPECT_EQ(traversal.closest({{0, 0, 0}, 1e10f, {-0.0f, 0, -0.0f}, 0}).triangle, shared::kNoHit);
    EXPECT_FALSE(traversal.occluded({{nan, 0, 0}, 1e10f, {0, 0, 1}, 0}));
    EXPECT_FALSE(traversal.occluded({{0, 0, 0}, 1e10f, {nan, nan, nan}, 0}));
    EXPECT_FALSE(traversal.occluded({{0, 0, 0}, -1.0f, {0, 0, 1}, 0}));
    EXPECT_TRUE(traversal.occluded({{0, 0, 0}, 1e10f, {0, 0, 1}, 0}));
}

TEST(BvhTraverse, TheIntervalIsOpen) {
    Scene scene;
    test::addTriangle(scene, {-1, -1, 0.5f}, {1, -1, 0.5f}, {0, 1, 0.5f});
    const Traversal traversal(scene);
    EXPECT_FALSE(traversal.occluded({{0, 0, 0}, 0.5f, {0, 0, 1}, 0}));
    EXPECT_TRUE(traversal.occluded({{0, 0, 0}, std::nextafter(0.5f, 1.0f), {0, 0, 1}, 0}));
    EXPECT_FALSE(traversal.occluded({{0, 0, 0.5f}, 1.0f, {0, 0, 1}, 0}));
}

TEST(BvhTraverse, OfTwinsTheFirstInLeafOrderWins) {
    Scene scene = test::closedBox(4);
    const std::vector<Triangle> once = scene.triangles;
    for (int copy = 0; copy < 3; ++copy) scene.triangles.insert(scene.triangles.end(), once.begin(), once.end());
    expectSameAsBruteForce(scene, test::randomRays(2000, 6));
}

TEST(BvhTraverse, NoRayEscapesThroughEdgesAndVertices) {
    uint64_t escapes = 0;
    for (const float bulge : {0.0f, 0.5f}) {
        const Scene scene = test::closedBox(30, bulge);
        const Traversal traversal(scene);
        for (const RayQuery& ray : test::raysAtEdges(scene, 500000, 7)) {
            escapes += traversal.occluded(ray) ? 0 : 1;
            escapes += traversal.closest(ray).triangle != shared::kNoHit ? 0 : 1;
        }
    }
    EXPECT_EQ(escapes, 0u);
}

TEST(BvhTraverse, SliversAndTinyTrianglesStop) {
    Scene scene;
    test::addTriangle(scene, {-0.5f, 0.0f, 0.1f}, {0.5f, 0.0f, 0.1f}, {0.0f, 1e-6f, 0.1f});
    test::addTriangle(scene, {-1e-4f, -1e-4f, 0.2f}, {1e-4f, -1e-4f, 0.2f}, {0.0f, 1e-4f, 0.2f});
    test::addTriangle(scene, {0.3f, 0.3f, 0.3f}, {0.3f, 0.3f, 0.3f}, {0.4f, 0.4f, 0.3f});  // no area
    const Traversal traversal(scene);
    EXPECT_TRUE(traversal.occluded({{0, 3e-7f, 0}, 0.15f, {0, 0, 1}, 0}));
    EXPECT_TRUE(traversal.occluded({{0, 0, 0.15f}, 1.0f, {0, 0, 1}, 0}));
    EXPECT_FALSE(traversal.occluded({{0.35f, 0.35f, 0}, 1.0f, {0, 0, 1}, 0}));
}

TEST(BvhTraverse, AgreesWithEmbree) {
    const Scene scene = test::triangleSoup(3000, 0.15f, 8);
    const Traversal traversal(scene);
    const EmbreeReference embree(scene, true);
    uint32_t differences = 0;
    for (const RayQuery& ray : test::randomRays(50000, 9)) {
        const shared::Hit hit = traversal.closest(ray);
        const std::optional<ClosestHit> expected = embree.closest(ray);
        const bool isHit = hit.triangle != shared::kNoHit;
        differences += isHit != expected.has_value() ? 1 : 0;
        if (!isHit || !expected) continue;
        if (traversal.sceneTriangle(hit) != expected->triangle) {
            EXPECT_NEAR(hit.t, expected->t, 1e-5f * expected->t);
        } else {
            EXPECT_NEAR(hit.t, expected->t, 1e-4f * expected->t + 1e-6f);
        }
    }
    // Rays are aimed at random, so that none should pass within rounding of the outline of a triangle.
    EXPECT_LE(differences, 1u);
}

// Large and small triangles and slivers; directions down to grazing ones.
TEST(RayOffset, NoRayMeetsTheTriangleThatItLeaves) {
    std::mt19937 random(10);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    uint32_t hits = 0;
    uint32_t hitsOfSlivers = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 a = test::randomPoint(random, -0.57f, 0.57f);
        const float size = std::exp2(-12.0f * unit(random));
        const glm::vec3 b = a + size * test::randomPoint(random, -0.57f, 0.57f);
        const bool isSliver = i % 4 == 0;
        const glm::vec3 c = isSliver ? glm::mix(a, b, unit(random)) + 1e-3f * size * test::randomPoint(random)
                                     : a + size * test::randomPoint(random, -0.57f, 0.57f);
        const glm::vec3 across = glm::cross(b - a, c - a);
        if (glm::length(across) == 0.0f) continue;
        Scene scene;
        test::addTriangle(scene, a, b, c);
        const Traversal traversal(scene);
        const glm::vec3 normal = glm::normalize(across) * (i % 2 == 0 ? 1.0f : -1.0f);
        for (int k = 0; k < 50; ++k) {
            glm::vec2 weights{unit(random), unit(random)};
            if (weights.x + weights.y > 1.0f) weights = 1.0f - weights;
            const glm::vec3 point = (1.0f - weights.x - weights.y) * a + weights.x * b + weights.y * c;
            glm::vec3 direction = glm::normalize(test::randomPoint(random));
            direction -= (1.0f - std::exp2(-10.0f * unit(random))) * glm::dot(direction, normal) * normal;
            if (glm::dot(direction, normal) < 0.0f) direction -= 2.0f * glm::dot(direction, normal) * normal;
            const bool isHit = traversal.occluded({shared::offsetPoint(point, normal), 10.0f, direction, 0.0f});
            (isSliver ? hitsOfSlivers : hits) += isHit ? 1 : 0;
        }
    }
    EXPECT_EQ(hits, 0u);
    // The distance to a triangle a thousand times longer than wide is known to 1e-4 of its length: of 50000, a few err.
    EXPECT_LE(hitsOfSlivers, 25u);
}

TEST(RaySets, PointsOfAConvexRoomSeeEachOther) {
    const Scene room = test::closedBox(8);
    const Traversal traversal(room);
    const std::vector<SurfacePoint> points = randomSurfacePoints(room, 2000, 11);
    ASSERT_EQ(points.size(), 2000u);
    for (size_t i = 1; i < points.size(); ++i) {
        if (std::abs(glm::dot(points[i].normal, points[i].position - points[0].position)) < 1e-3f) continue;
        if (std::abs(glm::dot(points[0].normal, points[i].position - points[0].position)) < 1e-3f) continue;
        ASSERT_FALSE(traversal.occluded(coherentShadowRays({points[i]}, points[0])[0])) << i;
    }
}

TEST(RaySets, PrimaryRaysCoverThePicture) {
    Camera camera;
    camera.verticalFov = 1.5707964f;
    const RaySet rays = primaryRays(camera, 20, 10);
    ASSERT_EQ(rays.size(), 200u);
    glm::vec3 sum{0.0f};
    float widest = 0.0f;
    for (const RayQuery& ray : rays) {
        EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f);
        sum += ray.direction / -ray.direction.z;
        widest = std::max(widest, ray.direction.x / -ray.direction.z);
    }
    EXPECT_NEAR(sum.x, 0.0f, 1e-4f);
    EXPECT_NEAR(sum.y, 0.0f, 1e-4f);
    EXPECT_NEAR(widest, 1.9f, 1e-5f);  // half width 2, less half a pixel
}

TEST(RaySets, BounceRaysLeaveTheirSurfaces) {
    const Scene room = test::closedBox(4);
    Camera camera;
    const std::vector<SurfacePoint> points = surfacePoints(room, primaryRays(camera, 40, 40));
    ASSERT_EQ(points.size(), 1600u);  // no ray leaves the room
    const RaySet rays = diffuseBounceRays(points, 12);
    double cosineSum = 0.0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const float cosine = glm::dot(rays[i].direction, points[i].normal);
        ASSERT_GE(cosine, 0.0f);
        cosineSum += static_cast<double>(cosine);
    }
    EXPECT_NEAR(cosineSum / 1600.0, 2.0 / 3.0, 0.03);  // the mean cosine of a cosine distribution; 5 sigma
}

}  // namespace
}  // namespace manylight
