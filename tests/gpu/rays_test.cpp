// Ray casting on the device against testing every triangle and against Embree.
#include "engine/accel/embree_reference.h"
#include "engine/techniques/ray_caster.h"
#include "shaders/shared/bvh_ray.h"
#include "tests/gpu/gpu_test.h"
#include "tests/unit/bvh_scenes.h"

#include <cstring>

namespace manylight {
namespace {

using shared::RayHit;
using shared::RayQuery;
using Rays = test::GpuTest;

constexpr float kFar = 1e10f;

/// A scene's meshes alone, as the device wants them.
Scene withMaterial(Scene scene) {
    scene.materials.resize(1);
    return scene;
}

struct Answers {
    std::vector<uint32_t> occluded;
    std::vector<RayHit> hits;
    std::vector<uint32_t> triangleOrder;  // leaf order -> Scene::triangles
};

Answers cast(const Scene& mesh, const RaySet& rays) {
    const Scene scene = withMaterial(mesh);
    const Bvh bvh = buildBvh(scene);
    RayCaster caster(test::device(), scene, bvh);
    caster.load(rays);
    caster.trace(RayKind::AnyHit);
    Answers answers{caster.occludedFlags(), {}, bvh.triangleOrder};
    caster.trace(RayKind::ClosestHit);
    answers.hits = caster.hits();
    return answers;
}

bool isHit(const RayHit& hit) { return hit.triangle != shared::kNoHit; }

/// The same triangle test on all triangles in leaf order, without boxes.
RayHit bruteForce(const Scene& scene, const std::vector<uint32_t>& order, const RayQuery& query) {
    RayHit best{query.tMax, shared::kNoHit, glm::vec2(0.0f)};
    if (query.direction == glm::vec3(0.0f)) return best;
    const shared::TraversalRay ray = shared::makeTraversalRay(query.origin, query.direction);
    for (uint32_t i = 0; i < order.size(); ++i) {
        const auto& corner = scene.triangles[order[i]].vertex;
        const shared::TriangleHit hit =
            shared::intersectTriangle(ray, scene.vertices[corner[0]].position, scene.vertices[corner[1]].position,
                                      scene.vertices[corner[2]].position, query.tMax);
        if (hit.isHit && hit.t < best.t) best = {hit.t, i, hit.barycentrics};
    }
    return best;
}

/// A device may divide with an error of 2.5 units in the last place, so that a ray within rounding of an outline may
/// fall on the other side: `allowed` of them.
void expectSameAsBruteForce(const Scene& scene, const RaySet& rays, uint32_t allowed = 0) {
    const Answers answers = cast(scene, rays);
    uint32_t differences = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const RayHit expected = bruteForce(scene, answers.triangleOrder, rays[i]);
        const RayHit& hit = answers.hits[i];
        ASSERT_EQ(answers.occluded[i] != 0, isHit(hit)) << "ray " << i << ": any hit, closest hit";
        if (isHit(hit) != isHit(expected)) {
            ++differences;
        } else if (isHit(hit)) {
            ASSERT_NEAR(hit.t, expected.t, 1e-4f * expected.t + 1e-6f) << "ray " << i;
            if (answers.triangleOrder[hit.triangle] == answers.triangleOrder[expected.triangle]) {
                ASSERT_NEAR(hit.barycentrics.x, expected.barycentrics.x, 1e-3f) << "ray " << i;
                ASSERT_NEAR(hit.barycentrics.y, expected.barycentrics.y, 1e-3f) << "ray " << i;
            }
        }
    }
    EXPECT_LE(differences, allowed);
}

TEST_F(Rays, RandomRaysFindWhatTestingAllTrianglesFinds) {
    const RaySet rays = test::randomRays(20000, 1);
    expectSameAsBruteForce(test::triangleSoup(800, 0.2f, 1), rays, 1);
    expectSameAsBruteForce(test::triangleSoup(200, 1.5f, 2), rays, 1);
    expectSameAsBruteForce(test::closedBox(6, 0.5f), rays, 1);
}

TEST_F(Rays, AxisAlignedRaysAndSignedZeros) {
    const RaySet rays = test::signedZeroRays();
    expectSameAsBruteForce(test::closedBox(4), rays);
    expectSameAsBruteForce(test::closedBox(3), rays);
    expectSameAsBruteForce(test::triangleSoup(400, 0.5f, 3), rays);
}

TEST_F(Rays, OriginsOnTheSlabs) {
    // Boxes of the tree have their planes on the grid that the origins are on.
    std::mt19937 random(4);
    RaySet rays;
    for (uint32_t i = 0; i < 20000; ++i) {
        glm::vec3 origin = test::randomPoint(random);
        glm::vec3 direction = test::randomPoint(random);
        for (int axis = 0; axis < 3; ++axis) {
            if (random() % 2 == 0) origin[axis] = 0.125f * std::round(origin[axis] / 0.125f);
            if (random() % 4 == 0) direction[axis] = random() % 2 == 0 ? 0.0f : -0.0f;
        }
        rays.push_back({origin, kFar, direction, 0.0f});
    }
    expectSameAsBruteForce(test::closedBox(8), rays);
}

TEST_F(Rays, ZeroDirectionsMiss) {
    const RaySet rays = {{{0, 0, 0}, kFar, {0, 0, 0}, 0},
                         {{0, 0, 0.5f}, kFar, {-0.0f, 0, -0.0f}, 0},
                         {{0.5f, 0.5f, 0.5f}, 1.0f, {-0.0f, -0.0f, -0.0f}, 0},
                         {{0, 0, 0}, kFar, {0, 0, 1}, 0}};
    const Answers answers = cast(test::closedBox(4), rays);
    EXPECT_EQ(answers.occluded, (std::vector<uint32_t>{0, 0, 0, 1}));
    for (size_t i = 0; i < 3; ++i) EXPECT_FALSE(isHit(answers.hits[i])) << i;
    EXPECT_EQ(answers.hits[3].t, 0.5f);
}

TEST_F(Rays, NoneOfAMillionEscapesThroughEdgesAndVertices) {
    for (const float bulge : {0.0f, 0.5f}) {
        const Scene scene = test::closedBox(30, bulge);
        const Answers answers = cast(scene, test::raysAtEdges(scene, 500000, 5));
        ASSERT_EQ(answers.occluded.size(), 500000u);
        EXPECT_EQ(std::count(answers.occluded.begin(), answers.occluded.end(), 0u), 0);
        EXPECT_TRUE(std::all_of(answers.hits.begin(), answers.hits.end(), isHit));
    }
}

TEST_F(Rays, AgreesWithEmbree) {
    const Scene scene = test::triangleSoup(3000, 0.15f, 6);
    const EmbreeReference embree(scene, true);
    const RaySet rays = test::randomRays(100000, 7);
    const Answers answers = cast(scene, rays);
    uint32_t differences = 0;
    uint32_t otherTriangles = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const std::optional<ClosestHit> expected = embree.closest(rays[i]);
        const RayHit& hit = answers.hits[i];
        differences += embree.occluded(rays[i]) != (answers.occluded[i] != 0) ? 1 : 0;
        differences += expected.has_value() != isHit(hit) ? 1 : 0;
        if (!expected || !isHit(hit)) continue;
        ASSERT_NEAR(hit.t, expected->t, 1e-4f * expected->t + 1e-6f) << "ray " << i;
        otherTriangles += answers.triangleOrder[hit.triangle] != expected->triangle ? 1 : 0;
    }
    // Rays are aimed at random, so that hardly any should pass within rounding of the outline of a triangle, or of
    // where two triangles cross.
    EXPECT_LE(differences, 2u);
    EXPECT_LE(otherTriangles, 2u);
}

TEST_F(Rays, NoTriangleNoHit) {
    const Answers answers = cast(Scene{}, test::signedZeroRays());
    EXPECT_EQ(std::count(answers.occluded.begin(), answers.occluded.end(), 0u),
              static_cast<ptrdiff_t>(answers.occluded.size()));
    EXPECT_TRUE(std::none_of(answers.hits.begin(), answers.hits.end(), isHit));
}

TEST_F(Rays, NoRaysNoAnswers) {
    const Answers answers = cast(test::closedBox(1), {});
    EXPECT_TRUE(answers.occluded.empty());
    EXPECT_TRUE(answers.hits.empty());
}

TEST_F(Rays, AFewTriangles) {
    for (const uint32_t count : {1u, 2u, 4u, 5u, 9u})
        expectSameAsBruteForce(test::triangleSoup(count, 1.5f, count), test::randomRays(2000, count), 1);
}

/// `count` times the same triangle, in the plane z = 0.
Scene coincidentTriangles(uint32_t count) {
    Scene scene;
    for (uint32_t i = 0; i < count; ++i) test::addTriangle(scene, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
    return scene;
}

TEST_F(Rays, OfThousandsOfTwinsTheSameOneWins) {
    const RaySet rays = {{{0, 0, -0.5f}, kFar, {0, 0, 1}, 0},
                         {{0.1f, 0.1f, 0.5f}, kFar, {0, 0, -1}, 0},
                         {{2, 2, -0.5f}, kFar, {0, 0, 1}, 0}};
    const Answers answers = cast(coincidentTriangles(5000), rays);
    EXPECT_EQ(answers.occluded, (std::vector<uint32_t>{1, 1, 0}));
    for (size_t i = 0; i < 2; ++i) EXPECT_EQ(answers.hits[i].t, 0.5f);
    EXPECT_EQ(answers.hits[0].triangle, answers.hits[1].triangle);
    EXPECT_FALSE(isHit(answers.hits[2]));
}

/// Triangles with the same box, of which only the last one is met: a traversal must look at all of them. Where a driver
/// with a loop limit ends it early, the answer must be refused.
TEST_F(Rays, ARayCutOffByTheDriverIsAnError) {
    Scene scene;
    for (uint32_t i = 0; i < 200000; ++i) test::addTriangle(scene, {-1, -1, 0}, {1, -1, 0}, {-1, 1, 0});
    test::addTriangle(scene, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    scene = withMaterial(std::move(scene));
    RayCaster caster(test::device(), scene, buildBvh(scene));
    caster.load(RaySet{{{0.5f, 0.5f, -0.5f}, kFar, {0, 0, 1}, 0}});
    bool isRefused = false;
    try {
        caster.trace(RayKind::AnyHit);
    } catch (const Error&) {
        isRefused = true;
    }
    EXPECT_TRUE(isRefused || caster.occludedFlags()[0] == 1);
}

TEST_F(Rays, SameBytesTwice) {
    const Scene scene = test::triangleSoup(2000, 0.3f, 8);
    const RaySet rays = test::randomRays(50000, 9);
    const Answers first = cast(scene, rays);
    const Answers second = cast(scene, rays);
    EXPECT_EQ(first.occluded, second.occluded);
    ASSERT_EQ(first.hits.size(), second.hits.size());
    EXPECT_EQ(std::memcmp(first.hits.data(), second.hits.data(), first.hits.size() * sizeof(RayHit)), 0);
}

}  // namespace
}  // namespace manylight
