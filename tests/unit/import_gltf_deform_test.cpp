// Morph targets and skins, at rest.
#include "engine/scene/instances.h"
#include "tests/unit/import_gltf_support.h"

#include <gmock/gmock.h>

#include <limits>

namespace manylight::testing {
namespace {

using ::testing::HasSubstr;

template <typename T>
std::string bytesOf(std::initializer_list<T> numbers) {
    std::string bytes;
    append<T>(bytes, numbers);
    return bytes;
}

std::string floats(std::initializer_list<float> numbers) { return bytesOf<float>(numbers); }

class Morphed : public GltfImport {
  protected:
    /// Target 0 lifts the third corner by 2 and tilts its normal; target 1 moves the second along x by 1.
    Morphed() {
        lift_ = addAccessor(floats({0, 0, 0, 0, 0, 0, 0, 0, 2}), 5126, "VEC3");
        tilt_ = addAccessor(floats({0, 0, 0, 0, 0, 0, 0, -2, 0}), 5126, "VEC3");
        const size_t move = addAccessor(floats({0, 0, 0, 1, 0, 0, 0, 0, 0}), 5126, "VEC3");
        primitive()["targets"] = {{{"POSITION", lift_}, {"NORMAL", tilt_}}, {{"POSITION", move}}};
    }
    glm::dvec3 corner(const Scene& scene, size_t index) const { return filePosition(scene, 0, index); }

    size_t lift_ = 0;
    size_t tilt_ = 0;
};

TEST_F(Morphed, HalfAWeightGoesHalfTheWay) {
    json_["meshes"][0]["weights"] = {0.5, 0};
    const Scene scene = importJson();
    EXPECT_TRUE(isNear(corner(scene, 1), {1, 0, 0}));
    EXPECT_TRUE(isNear(corner(scene, 2), {0, 1, 1}));
    EXPECT_TRUE(isNear(cornerOf(scene, 0, 2).normal, glm::normalize(glm::dvec3(0, -1, 1))));
    EXPECT_TRUE(isNear(cornerOf(scene, 0, 1).normal, {0, 0, 1}));
    EXPECT_EQ(scene.warnings.count("glTF morph weights of wrong number"), 0u);
}

TEST_F(Morphed, TargetsAddUpAndMayOvershoot) {
    json_["meshes"][0]["weights"] = {-1, 3};
    const Scene scene = importJson();
    EXPECT_TRUE(isNear(corner(scene, 1), {4, 0, 0}));
    EXPECT_TRUE(isNear(corner(scene, 2), {0, 1, -2}));
}

TEST_F(Morphed, WeightsOfTheNodeComeBeforeThoseOfTheMesh) {
    EXPECT_TRUE(isNear(corner(importJson(), 2), {0, 1, 0}));  // none: zero
    json_["meshes"][0]["weights"] = {1, 1};
    json_["nodes"][0]["weights"] = {0.25, 0};
    const Scene scene = importJson();
    EXPECT_TRUE(isNear(corner(scene, 2), {0, 1, 0.5}));
    EXPECT_TRUE(isNear(corner(scene, 1), {1, 0, 0}));
}

TEST_F(Morphed, WeightsOfWrongNumberAreCountedAndTheRestIsZero) {
    json_["meshes"][0]["weights"] = {1};
    EXPECT_EQ(importJson().warnings.count("glTF morph weights of wrong number"), 1u);
    EXPECT_TRUE(isNear(corner(importJson(), 1), {1, 0, 0}));
    json_["nodes"][0]["weights"] = {0, 1, 7};
    EXPECT_EQ(importJson().warnings.count("glTF morph weights of wrong number"), 2u);
    EXPECT_TRUE(isNear(corner(importJson(), 1), {2, 0, 0}));
}

TEST_F(Morphed, DifferencesMayBeQuantisedOrSparse) {
    const size_t quantised = addAccessor(bytesOf<int8_t>({0, 0, 0, 0, 0, 0, 0, 0, -127}), 5120, "VEC3", true);
    const size_t sparse = addAccessor(bytesOf<uint16_t>({1}) + std::string(2, '\0') + floats({0, 0, 8}), 5126, "VEC3");
    Json& accessor = json_["accessors"][sparse];
    const Json view = accessor["bufferView"];
    accessor.erase("bufferView");
    accessor["sparse"] = {{"count", 1},
                          {"indices", {{"bufferView", view}, {"componentType", 5123}}},
                          {"values", {{"bufferView", view}, {"byteOffset", 4}}}};
    primitive()["targets"] = {{{"POSITION", quantised}}, {{"POSITION", sparse}}};
    json_["meshes"][0]["weights"] = {0.5, 0.25};
    const Scene scene = importJson();
    EXPECT_TRUE(isNear(corner(scene, 2), {0, 1, -0.5}));
    EXPECT_TRUE(isNear(corner(scene, 1), {1, 0, 2}));
}

TEST_F(Morphed, ColoursAndTextureCoordinatesFollow) {
    const size_t base = addAccessor(floats({0.5f, 0.5f, 0.5f, 0, 0, 0, 1, 1, 1}), 5126, "VEC3");
    primitive()["attributes"]["COLOR_0"] = base;
    const size_t colours = addAccessor(floats({0.5f, 0, -0.5f, 1, 1, 1, 1, 0, 0}), 5126, "VEC3");
    const size_t uvs = addAccessor(floats({0, 0, 2, -4, 0, 0}), 5126, "VEC2");
    primitive()["targets"] = {{{"COLOR_0", colours}, {"TEXCOORD_0", uvs}}};
    json_["meshes"][0]["weights"] = {0.5};
    const Scene scene = importJson();
    EXPECT_TRUE(isNear(cornerOf(scene, 0, 0).colour, {0.75, 0.5, 0.25}));
    EXPECT_TRUE(isNear(cornerOf(scene, 0, 2).colour, {1, 1, 1}));  // not 1.5
    EXPECT_EQ(scene.warnings.count("vertex colours brought into [0, 1]"), 0u);
    EXPECT_EQ(cornerOf(scene, 0, 1).uv, glm::vec2(2, -2));
}

TEST_F(Morphed, OnlyEqualWeightsShareAMesh) {
    json_["nodes"] = Json::parse(R"([{"mesh": 0, "weights": [1, 0]}, {"mesh": 0, "translation": [5, 0, 0]},
        {"mesh": 0, "weights": [1, 0], "translation": [10, 0, 0]}, {"mesh": 0, "translation": [15, 0, 0]}])");
    json_["scenes"][0]["nodes"] = {0, 1, 2, 3};
    const Scene scene = importScene(write("a.gltf", json_.dump()), {.instances = InstanceMode::Share});
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.instances.size(), 4u);
    const Scene flat = flattened(scene);
    ASSERT_EQ(flat.triangles.size(), 4u);
    for (size_t t = 0; t < 4; ++t) {
        const glm::dvec3 third = filePosition(flat, t, 2);
        const bool isLifted = isNear(third, {0, 1, 2}, 1e-5) || isNear(third, {10, 1, 2}, 1e-5);
        const bool isFlat = isNear(third, {5, 1, 0}, 1e-5) || isNear(third, {15, 1, 0}, 1e-5);
        EXPECT_TRUE(isLifted || isFlat) << third.x << " " << third.y << " " << third.z;
    }
}

/// A bar along x: a corner at the root, one at the tip that follows the second joint, one in between that follows both.
class Skinned : public GltfImport {
  protected:
    Skinned() {
        setPositions({0, 0, 0, 2, 0, 0, 1, 1, 1});
        primitive()["attributes"]["NORMAL"] = addAccessor(floats({0, 0, 1, 0, 1, 0, 0, 0, 1}), 5126, "VEC3");
        setJoints(addAccessor(bytesOf<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}), 5121, "VEC4"));
        setWeights({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0});
        const float half = std::sqrt(0.5f);
        json_["nodes"] = Json::parse(R"([{"mesh": 0, "skin": 0, "translation": [100, 0, 0], "scale": [7, 7, 7]},
            {"children": [2], "translation": [0, 0, 5]}, {"children": [3]}, {"translation": [1, 0, 0]}])");
        json_["nodes"][3]["rotation"] = {0, 0, half, half};
        json_["scenes"][0]["nodes"] = {0, 1};
        const size_t bind = addAccessor(
            floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1}),
            5126, "MAT4");
        json_["accessors"][bind]["count"] = 2;
        json_["skins"] = {{{"joints", {2, 3}}, {"inverseBindMatrices", bind}}};
    }
    void setPositions(std::initializer_list<float> positions) {
        const size_t accessor = addAccessor(floats(positions), 5126, "VEC3");
        json_["accessors"][accessor]["min"] =
            json_["accessors"][accessor]["max"] = {0, 0, 0};  // they are only asked for
        primitive()["attributes"]["POSITION"] = accessor;
    }
    void setJoints(size_t accessor) { primitive()["attributes"]["JOINTS_0"] = accessor; }
    void setWeights(std::initializer_list<float> weights) {
        primitive()["attributes"]["WEIGHTS_0"] = addAccessor(floats(weights), 5126, "VEC4");
    }
    /// The bar bent at its second joint by 90 degrees, lifted by the root's parent; its node's place does not count.
    static void expectBent(const Scene& scene) {
        ASSERT_EQ(scene.triangles.size(), 1u);
        EXPECT_TRUE(isNear(filePosition(scene, 0, 0), {0, 0, 5}));
        EXPECT_TRUE(isNear(filePosition(scene, 0, 1), {1, 1, 5}));
        EXPECT_TRUE(isNear(filePosition(scene, 0, 2), {0.5, 0.5, 6}));
        EXPECT_TRUE(isNear(cornerOf(scene, 0, 1).normal, {-1, 0, 0}));
    }
};

TEST_F(Skinned, ABarOfTwoJointsBends) {
    const Scene scene = importJson();
    expectBent(scene);
    EXPECT_EQ(scene.warnings.entries().size(), 2u) << scene.warnings.toText();  // no camera, no light
}

TEST_F(Skinned, InverseBindMatricesMayBeMissing) {
    json_["skins"][0].erase("inverseBindMatrices");
    const Scene scene = importJson();
    EXPECT_TRUE(isNear(filePosition(scene, 0, 0), {0, 0, 5}));
    EXPECT_TRUE(isNear(filePosition(scene, 0, 1), {1, 2, 5}));
}

TEST_F(Skinned, NormalsAreTransformedByTheInverseTranspose) {
    json_["nodes"][2]["scale"] = {2, 1, 1};
    primitive()["attributes"]["NORMAL"] = addAccessor(floats({1, 1, 0, 0, 1, 0, 0, 0, 1}), 5126, "VEC3");
    EXPECT_TRUE(isNear(cornerOf(importJson(), 0, 0).normal, glm::normalize(glm::dvec3(0.5, 1, 0))));
}

TEST_F(Skinned, JointsAndWeightsMayBeQuantised) {
    for (const int type : {5121, 5123}) {
        const auto integers = [&](std::initializer_list<uint8_t> numbers) {
            std::string bytes;
            for (const uint8_t number : numbers) {
                bytes += static_cast<char>(number);
                if (type == 5123) bytes += static_cast<char>(number == 255 ? 255 : 0);
            }
            return bytes;
        };
        setJoints(addAccessor(integers({0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}), type, "VEC4"));
        primitive()["attributes"]["WEIGHTS_0"] =
            addAccessor(integers({255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 0, 0}), type, "VEC4", true);
        const Scene scene = importJson();
        expectBent(scene);
        EXPECT_EQ(scene.warnings.count("joint weights normalised: their sum is not one"), 1u);  // one and one
    }
}

TEST_F(Skinned, EightJointsMayMoveAVertex) {
    setWeights({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0, 0, 0});
    primitive()["attributes"]["JOINTS_1"] =
        addAccessor(bytesOf<uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}), 5121, "VEC4");
    primitive()["attributes"]["WEIGHTS_1"] = addAccessor(floats({0, 0, 0, 0, 0, 0, 0, 0, 0.5f, 0, 0, 0}), 5126, "VEC4");
    expectBent(importJson());
}

TEST_F(Skinned, WeightsAreRepairedAndCounted) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    setWeights({0, 0, 0, 0, 0.25f, kNaN, 0, -1, 8, 8, 0, 0});
    const Scene scene = importJson();
    expectBent(scene);
    EXPECT_EQ(scene.warnings.count("joint weights set to zero: negative or not finite"), 2u);
    EXPECT_EQ(scene.warnings.count("joint weights normalised: their sum is not one"), 2u);
    EXPECT_EQ(scene.warnings.count("vertices that follow no joint: they follow the skin's first"), 1u);
}

TEST_F(Skinned, ExporterRoundingIsNotCounted) {
    setWeights({1, 0, 0, 0, 0.99999f, 0, 0, 0, 0.50001f, 0.5f, 0, 0});
    EXPECT_EQ(importJson().warnings.count("joint weights normalised: their sum is not one"), 0u);
    setWeights({1, 0, 0, 0, 0.99f, 0, 0, 0, 0.5f, 0.5f, 0, 0});
    EXPECT_EQ(importJson().warnings.count("joint weights normalised: their sum is not one"), 1u);
}

TEST_F(Skinned, MorphTargetsComeBeforeTheSkin) {
    primitive()["targets"] = {{{"POSITION", addAccessor(floats({0, 0, 0, 2, 0, 0, 0, 0, 0}), 5126, "VEC3")}}};
    json_["meshes"][0]["weights"] = {0.5};
    EXPECT_TRUE(isNear(filePosition(importJson(), 0, 1), {1, 2, 5}));
}

TEST_F(Skinned, MirroringJointsKeepTheFrontInFront) {
    primitive()["attributes"]["NORMAL"] = addAccessor(floats({0, -1, 1, 0, -1, 1, 0, -1, 1}), 5126, "VEC3");
    for (const double side : {1.0, -1.0}) {
        json_["nodes"][1]["scale"] = {side, 1, 1};
        const Scene scene = importJson();
        EXPECT_NEAR(filePosition(scene, 0, side > 0.0 ? 0 : 2).z, 5, 1e-6);
        for (size_t corner = 0; corner < 3; ++corner)
            EXPECT_GT(glm::dot(frontOf(scene, 0), glm::dvec3(cornerOf(scene, 0, corner).normal)), 0.0) << side;
    }
}

TEST_F(Skinned, MeshesWithSkinsAreNotShared) {
    json_["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 1;
    json_["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
    json_["scenes"][0]["nodes"] = {0, 1, 4};
    const Scene scene = importScene(write("a.gltf", json_.dump()), {.instances = InstanceMode::Share});
    EXPECT_TRUE(scene.instances.empty());
    EXPECT_EQ(scene.triangles.size(), 2u);
    EXPECT_EQ(scene.warnings.count("instances of meshes with skins ignored"), 1u);
}

TEST_F(Skinned, JointsMayBeOutsideTheScene) {
    json_["scenes"][0]["nodes"] = {0};
    const Scene scene = importJson();
    expectBent(scene);
    EXPECT_EQ(scene.warnings.count("glTF nodes outside the default scene"), 3u);
}

TEST_F(Skinned, PrimitivesWithoutJointsStayWithTheirNode) {
    primitive()["attributes"].erase("JOINTS_0");
    const Scene scene = importJson();
    EXPECT_TRUE(isNear(filePosition(scene, 0, 1), {114, 0, 0}, 1e-4));
    EXPECT_EQ(scene.warnings.count("glTF joints without weights"), 1u);
    EXPECT_EQ(scene.warnings.count("primitives with a skin but without joints: they stay with their node"), 1u);
}

TEST_F(Skinned, BrokenSkinsNameFileAndPath) {
    const Json right = json_;
    const auto expectError = [&](const char* pointer, const Json& value, const char* message) {
        json_ = right;
        json_[Json::json_pointer(pointer)] = value;
        EXPECT_THAT(errorOfJson(), HasSubstr(message)) << pointer << " = " << value;
    };
    expectError("/nodes/0/skin", 1, "a.gltf: nodes[0].skin: expected an index into skins (there are 1)");
    expectError("/nodes/0/skin", -1, "nodes[0].skin: expected an index into skins");
    expectError("/nodes/0/weights", Json{"a"}, "nodes[0].weights[0]: expected");
    expectError("/meshes/0/weights", Json{Json::object()}, "meshes[0].weights[0]: expected");
    expectError("/skins/0", 3, "skins[0]: expected");
    expectError("/skins/0/joints", Json::array(), "skins[0].joints: expected at least one joint");
    expectError("/skins/0/joints/1", 4, "skins[0].joints[1]: expected an index into nodes (there are 4)");
    expectError("/skins/0/joints/1", 2.5, "skins[0].joints[1]: expected an index into nodes");
    expectError("/skins/0/joints", Json{2},
                "attributes.JOINTS_0: vertex 1 follows joint 1, expected one of the skin's 1");
    expectError("/skins/0/skeleton", 4, "skins[0].skeleton: expected an index into nodes");
    expectError("/skins/0/inverseBindMatrices", 99, "skins[0].inverseBindMatrices: expected an index into accessors");
    expectError("/skins/0/inverseBindMatrices", 0, "skins[0].inverseBindMatrices: expected an accessor of MAT4, float");
    expectError("/skins/0/joints", Json({2, 3, 1}),
                "inverseBindMatrices: expected an accessor of MAT4, float, at least 3");
    expectError("/meshes/0/primitives/0/attributes/JOINTS_0", 0, "JOINTS_0: expected an accessor of VEC4, unsigned");
    expectError("/meshes/0/primitives/0/attributes/WEIGHTS_0", 0, "WEIGHTS_0: expected an accessor of VEC4, float");
    expectError("/nodes/3/children", Json{2}, "nodes[3].children[0]: expected a node that is no other");
}

TEST_F(Skinned, JointsInALoopAreAnError) {
    json_["scenes"][0]["nodes"] = {0};
    json_["nodes"][1].erase("children");
    json_["nodes"][3]["children"] = {2};
    EXPECT_THAT(errorOfJson(), HasSubstr("a.gltf: skins[0].joints[0]: nodes[2] is in a loop of nodes"));
}

TEST_F(Skinned, InverseBindMatricesMustBeFiniteAndAreTakenAsAffine) {
    const auto withLast = [&](float last) {
        const size_t bind = addAccessor(floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, last}), 5126, "MAT4");
        json_["accessors"][bind]["count"] = 1;
        json_["skins"][0] = {{"joints", {1}}, {"inverseBindMatrices", bind}};
    };
    setWeights({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
    setJoints(addAccessor(std::string(12, '\0'), 5121, "VEC4"));
    withLast(2);
    EXPECT_EQ(importJson().warnings.count("inverse bind matrices taken as affine: last row is not 0 0 0 1"), 1u);
    EXPECT_TRUE(isNear(filePosition(importJson(), 0, 1), {2, 0, 5}));
    withLast(std::numeric_limits<float>::infinity());
    EXPECT_THAT(errorOfJson(), HasSubstr("a.gltf: skins[0].inverseBindMatrices: matrix 0 is not finite"));
}

}  // namespace
}  // namespace manylight::testing
