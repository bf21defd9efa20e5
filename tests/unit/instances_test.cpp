// Which meshes are shared, and that they are then in the same places.
#include "engine/scene/instances.h"
#include "engine/scene/generate/forest.h"
#include "engine/scene/scene_plan.h"
#include "tests/unit/import_gltf_support.h"

#include <set>

namespace manylight {
namespace {

using testing::GltfImport;

TEST(Sharing, IsChosenWhereItSavesMuch) {
    const auto shares = [](const std::vector<RepeatedMesh>& meshes, InstanceMode mode = InstanceMode::Auto) {
        return chooseSharing(meshes, mode).shares;
    };
    EXPECT_TRUE(shares({{10000, 500}}));
    EXPECT_FALSE(shares({{10000, 1}}));
    EXPECT_FALSE(shares({{1000, 20}}));                   // too little
    EXPECT_FALSE(shares({{1'000'000, 1}, {10000, 50}}));  // most is there once
    EXPECT_FALSE(shares({{1, 10'000'000}}));              // an instance takes more than a triangle
    EXPECT_TRUE(shares({{1000, 20}}, InstanceMode::Share));
    EXPECT_FALSE(shares({{10000, 500}}, InstanceMode::Flatten));
    EXPECT_FALSE(shares({}, InstanceMode::Share));
    EXPECT_NEAR(
        static_cast<double>(chooseSharing(std::vector<RepeatedMesh>{{10000, 500}}, InstanceMode::Auto).savedBytes),
        499e4 * 72, 1e6);
}

TEST(Sharing, MoreTrianglesThanNumbersAreAnError) {
    Scene scene;
    scene.triangles.resize(1 << 16);
    scene.meshes = {{.triangleCount = 1 << 16}};
    scene.instances.resize((1 << 16) - 1);
    EXPECT_EQ(listInstances(scene).triangleCount(), 0xffff0000u);
    scene.instances.resize(1 << 16);
    EXPECT_THROW(listInstances(scene), Error);
}

/// Corners of all triangles in file units, rounded, so that the order of triangles does not matter.
std::multiset<std::array<long, 9>> cornersOf(const Scene& scene) {
    std::multiset<std::array<long, 9>> all;
    for (size_t t = 0; t < scene.triangles.size(); ++t) {
        std::array<std::array<long, 3>, 3> corners{};
        for (size_t c = 0; c < 3; ++c)
            for (int axis = 0; axis < 3; ++axis)
                corners[c][static_cast<size_t>(axis)] = std::lround(1e3 * testing::filePosition(scene, t, c)[axis]);
        // From the smallest corner on: turning a triangle is no change, turning it round is.
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        std::array<long, 9> flat{};
        for (size_t i = 0; i < 9; ++i) flat[i] = corners[i / 3][i % 3];
        all.insert(flat);
    }
    return all;
}

/// A nested tree of nodes: mirrored, stretched, flat, and by EXT_mesh_gpu_instancing.
void addNodes(Json& json) {
    json["scenes"] = Json::parse(R"([{"nodes": [0, 1, 4]}])");
    json["nodes"] = Json::parse(R"([
        {"mesh": 0, "translation": [5, 0, 0]},
        {"children": [2, 3], "scale": [2, 2, 2], "rotation": [0, 0.6, 0, 0.8]},
        {"mesh": 0, "translation": [0, 3, 1], "children": [5]},
        {"mesh": 0, "scale": [-1, 1, 1], "translation": [0, -4, 0]},
        {"mesh": 0, "scale": [1, 1, 0], "translation": [7, 7, 0]},
        {"mesh": 0, "scale": [1, 3, -0.5], "rotation": [0.6, 0, 0, 0.8], "children": [6]},
        {"mesh": 0, "scale": [-1, 2, 1], "translation": [0, -4, 9]}])");
}

class SharedGltf : public GltfImport {
  protected:
    Scene importAs(InstanceMode mode) { return importScene(write("a.gltf", json_.dump()), {.instances = mode}); }
};

TEST_F(SharedGltf, SharedMeshesAreWhereRepeatedOnesAre) {
    addNodes(json_);
    const Scene repeated = importAs(InstanceMode::Flatten);
    const Scene shared = importAs(InstanceMode::Share);
    EXPECT_TRUE(repeated.instances.empty());
    ASSERT_EQ(repeated.triangles.size(), 6u);
    ASSERT_EQ(shared.instances.size(), 6u);  // the flat one, which cannot be inverted, is among the scene's own
    EXPECT_EQ(shared.triangles.size(), 3u);  // one mesh and its mirror image
    const Scene flat = flattened(shared);
    EXPECT_EQ(cornersOf(flat), cornersOf(repeated));
    EXPECT_EQ(flat.frame.exponent, repeated.frame.exponent);
    for (size_t t = 0; t < flat.triangles.size(); ++t)
        for (size_t c = 0; c < 3; ++c) {
            // The file's triangle faces along its normals; so do all its images.
            const glm::vec3 front(testing::frontOf(flat, t));
            EXPECT_GT(glm::dot(glm::normalize(front), testing::cornerOf(flat, t, c).normal), 0.999f);
        }
    EXPECT_TRUE(planScene(shared).instanced);
    EXPECT_TRUE(planScene(shared).stretched);
    EXPECT_FALSE(planScene(repeated).instanced);
}

TEST_F(SharedGltf, BoundsHoldEveryInstance) {
    addNodes(json_);
    const Scene shared = importAs(InstanceMode::Share);
    const Scene repeated = importAs(InstanceMode::Flatten);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(shared.boundsMin[axis], repeated.boundsMin[axis], 1e-6f);
        EXPECT_NEAR(shared.boundsMax[axis], repeated.boundsMax[axis], 1e-6f);
    }
}

TEST_F(SharedGltf, AMeshShownOnceIsNoInstance) {
    EXPECT_TRUE(importAs(InstanceMode::Share).instances.empty());
    EXPECT_EQ(importAs(InstanceMode::Auto).sharing.reason, "no mesh is shown twice");
}

TEST_F(SharedGltf, AForestTakesTheMemoryOfItsTrees) {
    const ForestFiles files = writeForest({.triangleTarget = 600'000, .treeTriangles = 6'000}, folder_);
    const Scene forest = importScene(folder_ / "forest.json");
    EXPECT_TRUE(forest.sharing.shares) << forest.sharing.reason;
    EXPECT_NEAR(static_cast<double>(shownTriangles(forest)), static_cast<double>(files.trianglesShown), 6'000.0);
    EXPECT_LT(forest.triangles.size(), 2 * files.trianglesStored + 1000);  // some trees are mirror images
    EXPECT_TRUE(forest.warnings.entries().empty());
}

}  // namespace
}  // namespace manylight
