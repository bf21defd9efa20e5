// Key frames, and scenes that follow them.
#include "apps/view_model/playable_scene.h"
#include "engine/scene/animated_scene.h"
#include "engine/scene/gltf_animation.h"
#include "engine/scene/instances.h"
#include "tests/unit/import_gltf_support.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace manylight {
namespace {

using testing::GltfImport;

NodeChannel channelOf(NodeProperty property, KeyInterpolation interpolation, std::vector<double> times,
                      std::vector<double> values) {
    return {.node = 0,
            .property = property,
            .interpolation = interpolation,
            .times = std::move(times),
            .values = std::move(values)};
}

TEST(KeyFrames, AreInterpolatedAsTheyAsk) {
    const std::vector<double> values{0, 0, 0, 4, 8, 0};
    const NodeChannel linear = channelOf(NodeProperty::Translation, KeyInterpolation::Linear, {1, 3}, values);
    EXPECT_EQ(valueAt(linear, 0.0)[0], 0.0);
    EXPECT_EQ(valueAt(linear, 1.5)[0], 1.0);
    EXPECT_EQ(valueAt(linear, 1.5)[1], 2.0);
    EXPECT_EQ(valueAt(linear, 3.0)[0], 4.0);
    EXPECT_EQ(valueAt(linear, 99.0)[1], 8.0);
    const NodeChannel step = channelOf(NodeProperty::Scale, KeyInterpolation::Step, {1, 3}, values);
    EXPECT_EQ(valueAt(step, 2.999)[0], 0.0);
    EXPECT_EQ(valueAt(step, 3.0)[0], 4.0);
}

TEST(KeyFrames, CubicSplinesFollowTheirTangents) {
    // In-tangent, value, out-tangent of x^3 at 0 and 2: a cubic is its own spline.
    const NodeChannel cubic = channelOf(NodeProperty::Translation, KeyInterpolation::CubicSpline, {0, 2},
                                        {0, 0, 0, 0, 0, 0, 0, 0, 0, 12, 0, 0, 8, 0, 0, 12, 0, 0});
    for (const double time : {0.0, 0.3, 1.0, 1.7, 2.0}) EXPECT_NEAR(valueAt(cubic, time)[0], time * time * time, 1e-12);
}

TEST(KeyFrames, RotationsTurnTheShorterWayAtOneSpeed) {
    const double half = std::sqrt(0.5);  // 90 degrees about z, with the sign that lies further away
    const NodeChannel turn =
        channelOf(NodeProperty::Rotation, KeyInterpolation::Linear, {0, 1}, {0, 0, 0, 1, 0, 0, -half, -half});
    for (const double time : {0.25, 0.5, 0.9}) {
        const std::vector<double> q = valueAt(turn, time);
        EXPECT_NEAR(std::abs(q[2]), std::sin(time * 0.25 * std::numbers::pi), 1e-12) << time;
        EXPECT_NEAR(q[2] * q[2] + q[3] * q[3], 1.0, 1e-12);
    }
}

class Animated : public GltfImport {
  protected:
    /// The triangle's node, with a lamp and a camera below it, moves from x = 0 to 4 in two seconds.
    Animated() {
        json_["nodes"] = Json::parse(R"([{"mesh": 0, "children": [1, 2]},
            {"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0, 1, 0]},
            {"camera": 0, "translation": [0, 0, 9]}, {"mesh": 0, "translation": [0, -5, 0]}])");
        json_["scenes"][0]["nodes"] = {0, 3};
        json_["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([{"type": "point", "intensity": 3}])");
        json_["extensionsUsed"] = {"KHR_lights_punctual"};
        json_["cameras"] = Json::parse(R"([{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}])");
        times_ = keys(times({0, 1, 2}), "SCALAR");
        values_ = keys(times({0, 0, 0, 2, 0, 0, 4, 0, 0}), "VEC3");
        json_["animations"] =
            Json::array({{{"samplers", {{{"input", times_}, {"output", values_}}}},
                          {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}});
    }

    static std::string times(std::initializer_list<float> numbers) {
        std::string bytes;
        testing::append<float>(bytes, numbers);
        return bytes;
    }
    size_t keys(const std::string& bytes, const char* type) { return addAccessor(bytes, 5126, type); }
    Json& sampler() { return json_["animations"][0]["samplers"][0]; }
    Json& target() { return json_["animations"][0]["channels"][0]["target"]; }
    std::string path() const { return write("a.gltf", json_.dump()).string(); }
    std::string errorAt(double time) const {
        try {
            importScene(path(), {.time = time});
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }

    size_t times_ = 0;
    size_t values_ = 0;
};

TEST_F(Animated, MeshesLightsAndCamerasMoveWithTheirNodes) {
    const Scene rest = importScene(path());
    EXPECT_GT(rest.warnings.count("animations ignored: nodes keep their rest pose"), 0u);
    const Scene scene = importScene(path(), {.time = 1.5});
    EXPECT_TRUE(scene.warnings.entries().empty());
    EXPECT_EQ(scene.animationEnd, 2.0);
    EXPECT_NEAR(testing::filePosition(scene, 0, 0).x, 3.0, 1e-6);
    const auto inFile = [&](const glm::vec3& p) {
        return scene.frame.center + std::ldexp(1.0, scene.frame.exponent) * glm::dvec3(p);
    };
    EXPECT_NEAR(inFile(scene.lights.at(0).position).x, 3.0, 1e-5);
    EXPECT_NEAR(inFile(scene.lights.at(0).position).y, 1.0, 1e-5);
    EXPECT_NEAR(inFile(scene.cameras.at(0).origin).x, 3.0, 1e-5);
}

TEST_F(Animated, MovingOnIsTheSameAsReadingAnew) {
    const std::vector<double> times{0.0, 0.7, 2.0};
    AnimatedScene animated(path(), {}, times);
    ASSERT_EQ(animated.scene().instances.size(), 2u);  // one mesh, shown twice
    for (const double time : {0.7, 2.0, 0.0}) {
        EXPECT_EQ(animated.moveTo(time), AnimatedScene::Change::Places);
        const AnimatedScene anew(path(), {}, {time, 0.0, 0.7, 2.0});
        const Scene moved = flattened(animated.scene());
        const Scene read = flattened(anew.scene());
        ASSERT_EQ(moved.vertices.size(), read.vertices.size());
        for (size_t i = 0; i < moved.vertices.size(); ++i)
            EXPECT_EQ(moved.vertices[i].position, read.vertices[i].position) << time;
        EXPECT_EQ(moved.lights[0].position, read.lights[0].position);
        EXPECT_EQ(moved.cameras[0].origin, read.cameras[0].origin);
        EXPECT_EQ(moved.boundsMin, read.boundsMin);
        EXPECT_EQ(moved.boundsMax, read.boundsMax);
        EXPECT_LT(glm::length(moved.boundsMax - moved.boundsMin), 2.0f);
    }
}

TEST_F(Animated, ASidecarsMomentIsThatOfTheAnimationThatPlays) {
    const std::string file = path();
    const double end = animationEndOf(file, {});
    EXPECT_EQ(end, 2.0);
    AnimatedScene playing(file, {}, samplesOfMotion(end), 0.0);
    playing.moveTo(1.3);
    const Scene saved = import("saved.json", R"({"scene": "a.gltf", "at": 1.3})");
    EXPECT_TRUE(saved.warnings.empty()) << saved.warnings.toText();
    ASSERT_EQ(saved.instances.size(), playing.scene().instances.size());
    for (size_t i = 0; i < saved.instances.size(); ++i) {
        EXPECT_EQ(saved.instances[i].center, playing.scene().instances[i].center);
        EXPECT_EQ(saved.instances[i].sceneFromMesh, playing.scene().instances[i].sceneFromMesh);
    }
    EXPECT_EQ(saved.lights.at(0).position, playing.scene().lights.at(0).position);
    EXPECT_EQ(saved.cameras.at(0).origin, playing.scene().cameras.at(0).origin);
    EXPECT_EQ(saved.frame.center, playing.scene().frame.center);
    EXPECT_EQ(saved.boundsMax, playing.scene().boundsMax);

    const Scene ofTheUser = importScene(folder_ / "saved.json", {.time = 0.5});
    EXPECT_NEAR(testing::filePosition(ofTheUser, 0, 0).x, 1.0, 1e-6) << "--at goes first";
    EXPECT_EQ(errorOf("bad.json", R"({"scene": "a.gltf", "at": -1})"),
              (folder_ / "bad.json").string() + ": at: expected seconds, 0 or more, found -1");
    write("still.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(import("still.json", R"({"scene": "still.obj", "at": 1})")
                  .warnings.count("moments of an animation ignored: nothing moves"),
              1u);
}

TEST_F(Animated, IsReadOnceWhenItIsOpened) {
    constexpr size_t kPadding = size_t{1} << 22;
    json_["extras"] = std::string(kPadding, 'x');
    const std::string file = path();
    const auto bytesRead = [] {
        std::ifstream counters("/proc/self/io");  // of this process
        std::string name;
        size_t bytes = 0;
        counters >> name >> bytes;
        EXPECT_EQ(name, "rchar:");
        return bytes;
    };
    const size_t before = bytesRead();
    PlayableScene scene(file, InstanceMode::Auto, 0.5);
    const size_t read = bytesRead() - before;
    EXPECT_GE(read, kPadding);
    EXPECT_LT(read, kPadding + kPadding / 2);
    EXPECT_TRUE(scene.isAnimated());
    EXPECT_EQ(scene.time(), 0.5);
    scene.moveTo(1.0, false);
    EXPECT_LT(bytesRead() - before, kPadding + kPadding / 2) << "nor when it moves";
}

TEST_F(Animated, WhatTheFileAsAWholeLacksIsSaidOnce) {
    json_.erase("scene");  // the first is shown, counted
    const Scene alone = importScene(path(), {.time = 0.0});
    PlayableScene opened(path(), InstanceMode::Auto, 0.0);
    EXPECT_EQ(opened.scene().warnings.total(), alone.warnings.total());
    EXPECT_GT(alone.warnings.total(), 0u);
}

TEST_F(Animated, WhatShrinksToNothingOrTurnsInsideOutIsReadAnew) {
    target()["path"] = "scale";
    sampler()["output"] = keys(times({1, 1, 1, 0, 0, 0, -1, 1, 1}), "VEC3");
    AnimatedScene animated(path(), {}, {0.0, 1.0, 2.0});
    EXPECT_EQ(animated.moveTo(0.5), AnimatedScene::Change::Places);
    EXPECT_EQ(shownTriangles(animated.scene()), 2u);
    EXPECT_EQ(animated.moveTo(1.0), AnimatedScene::Change::Everything);
    EXPECT_EQ(shownTriangles(animated.scene()), 1u);
    EXPECT_EQ(animated.moveTo(2.0), AnimatedScene::Change::Everything);
    EXPECT_EQ(shownTriangles(animated.scene()), 2u);
}

TEST_F(Animated, WrongAnimationsAreErrorsWithTheirPlace) {
    const auto expectError = [&](const char* part) {
        const std::string error = errorAt(1.0);
        EXPECT_NE(error.find("a.gltf: animations[0]."), std::string::npos) << error;
        EXPECT_NE(error.find(part), std::string::npos) << error << " has no " << part;
    };
    const Json right = json_;
    json_["animations"][0]["channels"][0]["sampler"] = 1;
    expectError("channels[0].sampler");
    json_ = right;
    json_["animations"][0]["samplers"] = Json::array();
    expectError("channels[0].sampler");
    json_ = right;
    target()["node"] = 4;
    expectError("channels[0].target.node");
    json_ = right;
    sampler()["input"] = keys(times({0, 2, 1}), "SCALAR");
    expectError("samplers[0].input");
    json_ = right;
    sampler()["input"] = keys(times({0, std::numeric_limits<float>::quiet_NaN(), 2}), "SCALAR");
    expectError("samplers[0].input");
    json_ = right;
    sampler()["output"] = keys(times({0, 0, 0, 1, std::numeric_limits<float>::infinity(), 0, 0, 0, 0}), "VEC3");
    expectError("samplers[0].output");
    json_ = right;
    sampler()["interpolation"] = "CUBICSPLINE";  // needs three times as many
    expectError("samplers[0].output");
    json_ = right;
    sampler()["interpolation"] = "SPLINE";
    expectError("samplers[0].interpolation");
    json_ = right;
    sampler()["input"] = 99;
    expectError("samplers[0].input");
    json_ = right;
    target()["path"] = "rotation";  // of three components
    expectError("samplers[0].output");
    json_ = right;
    json_["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    expectError("channels[0].target.node");
    json_ = right;
    json_["accessors"][times_]["count"] = 0;
    EXPECT_NE(errorAt(1.0).find("accessors["), std::string::npos) << errorAt(1.0);
}

TEST_F(Animated, WeightsWithoutMorphTargetsAreCounted) {
    target()["path"] = "weights";
    const Scene scene = importScene(path(), {.time = 1.0});
    EXPECT_EQ(scene.warnings.count("animation channels ignored: weights without morph targets"), 1u);
    EXPECT_EQ(scene.animationEnd, 0.0);
    target()["path"] = "pointer";
    EXPECT_EQ(importScene(path(), {.time = 1.0}).warnings.count("animation channels ignored: no property of a node"),
              1u);
}

/// Two morph targets lift the third corner of the triangle by 1 each; their weights go from 0, 1 over 2, 1 to 4, -1.
class AnimatedShape : public Animated {
  protected:
    AnimatedShape() {
        const size_t lift = keys(times({0, 0, 0, 0, 0, 0, 0, 0, 1}), "VEC3");
        primitive()["targets"] = {{{"POSITION", lift}}, {{"POSITION", lift}}};
        json_["meshes"][0]["weights"] = {0.0, 0.0};
        target()["path"] = "weights";
        setOutput({0, 1, 2, 1, 4, -1});
    }
    void setOutput(std::initializer_list<float> numbers) {
        sampler()["output"] = keys(times(numbers), "SCALAR");
        json_["accessors"].back()["count"] = numbers.size();
    }
    double heightAt(double time) const { return testing::filePosition(importScene(path(), {.time = time}), 0, 2).z; }
    /// A bone below the moving node bends half of the triangle.
    void makeSkin() {
        target()["path"] = "rotation";
        const float half = std::sqrt(0.5f);
        sampler()["output"] = keys(times({0, 0, 0, 1, half, 0, 0, half, 1, 0, 0, 0}), "VEC4");
        target()["node"] = 4;
        json_["nodes"].push_back({{"name", "bone"}});
        json_["scenes"][0]["nodes"].push_back(4);
        json_["skins"] = {{{"joints", {4, 3}}}};
        json_["nodes"][0]["skin"] = 0;
        primitive()["attributes"]["JOINTS_0"] =
            addAccessor(std::string({1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}), 5121, "VEC4");
        primitive()["attributes"]["WEIGHTS_0"] = keys(times({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}), "VEC4");
    }
    void expectSameAsReadAnew(double time, const std::vector<double>& all, const Scene& shown) const {
        std::vector<double> others{time};
        others.insert(others.end(), all.begin(), all.end());
        const AnimatedScene anew(path(), {}, others);
        const Scene moved = flattened(shown);
        const Scene read = flattened(anew.scene());
        ASSERT_EQ(moved.vertices.size(), read.vertices.size());
        for (size_t i = 0; i < moved.vertices.size(); ++i)
            EXPECT_EQ(moved.vertices[i].position, read.vertices[i].position) << time;
        EXPECT_EQ(moved.frame.center, read.frame.center);
        EXPECT_EQ(moved.frame.exponent, read.frame.exponent);
        EXPECT_EQ(moved.boundsMin, read.boundsMin);
        EXPECT_EQ(moved.boundsMax, read.boundsMax);
    }
};

TEST_F(AnimatedShape, WeightsFollowTheirKeys) {
    EXPECT_NEAR(heightAt(0.0), 1.0, 1e-6);
    EXPECT_NEAR(heightAt(0.5), 2.0, 1e-6);  // 1 + 1
    EXPECT_NEAR(heightAt(1.5), 3.0, 1e-6);  // 3 + 0
    EXPECT_NEAR(heightAt(9.0), 3.0, 1e-6);
    EXPECT_EQ(importScene(path(), {.time = 0.5}).animationEnd, 2.0);
    sampler()["interpolation"] = "STEP";
    EXPECT_NEAR(heightAt(0.99), 1.0, 1e-6);
    EXPECT_NEAR(heightAt(1.0), 3.0, 1e-6);
}

TEST_F(AnimatedShape, WeightsMayBeCubicSplines) {
    // In-tangents, values and out-tangents, each for both targets: t^3 and -t^2 at 0, 1 and 2.
    setOutput({0, 0, 0, 0, 0, 0, 3, -2, 1, -1, 3, -2, 12, -4, 8, -4, 12, -4});
    sampler()["interpolation"] = "CUBICSPLINE";
    for (const double t : {0.0, 0.3, 1.0, 1.6, 2.0}) EXPECT_NEAR(heightAt(t), t * t * t - t * t, 1e-6) << t;
}

TEST_F(AnimatedShape, WeightsOfWrongNumberAreAnErrorWithItsPlace) {
    setOutput({0, 1, 2});  // one for each key, of two targets
    EXPECT_NE(errorAt(1.0).find("a.gltf: animations[0].samplers[0].output: expected an accessor of 6 elements"),
              std::string::npos)
        << errorAt(1.0);
    sampler()["output"] = values_;
    EXPECT_NE(errorAt(1.0).find("samplers[0].output: expected an accessor of type SCALAR"), std::string::npos);
}

TEST_F(AnimatedShape, WhatDeformsIsReadAnewInTheSameFrame) {
    const std::vector<double> all{0.0, 0.7, 2.0};
    AnimatedScene animated(path(), {}, all);
    const glm::dvec3 center = animated.scene().frame.center;
    for (const double time : {0.7, 2.0, 0.0}) {
        EXPECT_EQ(animated.moveTo(time), AnimatedScene::Change::Everything);
        EXPECT_EQ(animated.moveTo(time), AnimatedScene::Change::Places);
        EXPECT_EQ(animated.scene().frame.center, center);
        expectSameAsReadAnew(time, all, animated.scene());
    }
}

TEST_F(AnimatedShape, WhatMovesAndDeformsDoesBoth) {
    json_["animations"][0]["samplers"].push_back({{"input", times_}, {"output", values_}});
    json_["animations"][0]["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "translation"}}}});
    AnimatedScene animated(path(), {}, {0.0, 2.0});
    EXPECT_EQ(animated.moveTo(1.5), AnimatedScene::Change::Everything);
    const Scene flat = flattened(animated.scene());
    ASSERT_EQ(flat.triangles.size(), 2u);
    std::vector<glm::dvec3> thirds{testing::filePosition(flat, 0, 2), testing::filePosition(flat, 1, 2)};
    if (thirds[0].y < thirds[1].y) std::swap(thirds[0], thirds[1]);
    EXPECT_TRUE(testing::isNear(thirds[0], {3, 1, 3}, 1e-5));  // the other node's weights stay
    EXPECT_TRUE(testing::isNear(thirds[1], {0, -4, 0}, 1e-5));
}

TEST_F(AnimatedShape, SkinsFollowTheirJoints) {
    makeSkin();
    // A turn about x by 90 degrees a second: the third corner goes up, then round; the others follow a joint at rest.
    EXPECT_TRUE(testing::isNear(testing::filePosition(importScene(path(), {.time = 1.0}), 0, 2), {0, 0, 1}));
    const Scene between = importScene(path(), {.time = 0.5});
    EXPECT_TRUE(testing::isNear(testing::filePosition(between, 0, 2), {0, std::sqrt(0.5), std::sqrt(0.5)}));
    EXPECT_TRUE(testing::isNear(testing::filePosition(between, 0, 1), {1, -5, 0}));
    const std::vector<double> all{0.0, 0.7, 1.2};
    AnimatedScene animated(path(), {}, all);
    const glm::dvec3 center = animated.scene().frame.center;
    for (const double time : {0.7, 1.2}) {
        EXPECT_EQ(animated.moveTo(time), AnimatedScene::Change::Everything);
        EXPECT_EQ(animated.scene().frame.center, center);
        expectSameAsReadAnew(time, all, animated.scene());
    }
}

}  // namespace
}  // namespace manylight
