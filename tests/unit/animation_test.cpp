// Key frames, and scenes that follow them.
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
        const std::array<double, 4> q = valueAt(turn, time);
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

TEST_F(Animated, MorphWeightsAreCounted) {
    target()["path"] = "weights";
    const Scene scene = importScene(path(), {.time = 1.0});
    EXPECT_EQ(scene.warnings.count("animation channels ignored: no transform of a node"), 1u);
    EXPECT_EQ(scene.animationEnd, 0.0);
}

}  // namespace
}  // namespace manylight
