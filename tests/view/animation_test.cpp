// A scene that moves by itself, in the window and without one.
#include "tests/unit/import_gltf_support.h"
#include "tests/view/view_test.h"

#include <gmock/gmock.h>

namespace manylight::test {
namespace {

using ::testing::HasSubstr;

class ViewerAnimation : public ViewerTest {
  protected:
    /// Over a large triangle, a small one moves from x = -1 to 1 in two seconds, with a lamp.
    ViewerAnimation() {
        Json json = testing::triangleJson();
        json["buffers"][0]["uri"] = testing::dataUri(testing::triangleData());
        json["nodes"] = Json::parse(R"([{"mesh": 0, "children": [2]},
            {"mesh": 0, "scale": [6, 6, 1], "translation": [-2, -2, -1]},
            {"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0.2, 0.3, 1]},
            {"camera": 0, "translation": [0, 0, 4]}])");
        json["scenes"][0]["nodes"] = {0, 1, 3};
        json["extensionsUsed"] = {"KHR_lights_punctual"};
        json["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([{"type": "point", "intensity": 30}])");
        json["cameras"] = Json::parse(R"([{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}}])");
        std::string keys;
        testing::append<float>(keys, {0, 2});
        testing::append<float>(keys, {-1, 0, 0, 1, 0, 0});
        json["buffers"].push_back({{"byteLength", keys.size()}, {"uri", testing::dataUri(keys)}});
        json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 8}});
        json["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 8}, {"byteLength", 24}});
        json["accessors"].push_back({{"bufferView", 4}, {"componentType", 5126}, {"count", 2}, {"type", "SCALAR"}});
        json["accessors"].push_back({{"bufferView", 5}, {"componentType", 5126}, {"count", 2}, {"type", "VEC3"}});
        json["animations"] =
            Json::array({{{"samplers", {{{"input", 4}, {"output", 5}}}},
                          {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}});
        write("moving.gltf", json.dump());
        scene_ = "moving.gltf";
    }
};

TEST_F(ViewerAnimation, AtATimeIsThePictureWithoutAWindow) {
    view("set panel off\nset at 0.5\nframes 2\ncapture half.png\nset at 2\nframes 2\ncapture end.png", "--vpls 12");
    view("set panel off\nframes 2\ncapture opened.png", "--vpls 12 --at 0.5 --instances share");
    const std::string still = fmt::format(
        " moving.gltf --size {}x{} --bounces 2 --light-samples 4 --vpls 12 --frames 2 --animate 0:2:2 -o at_#.png",
        kWidth, kHeight);
    ASSERT_EQ(run(program("capture") + still), 0) << textOf("output");
    EXPECT_GT(largestDifference(imageOf("at_1.png"), imageOf("at_4.png")), 20);
    EXPECT_EQ(largestDifference(imageOf("half.png"), imageOf("at_1.png")), 0);
    EXPECT_EQ(largestDifference(imageOf("end.png"), imageOf("at_4.png")), 0);
    EXPECT_EQ(largestDifference(imageOf("opened.png"), imageOf("at_1.png")), 0);
}

TEST_F(ViewerAnimation, WhatDeformsIsThePictureWithoutAWindow) {
    Json json = jsonOf("moving.gltf");
    json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 1}}};  // towards the camera, by the time
    json["animations"][0]["samplers"].push_back({{"input", 4}, {"output", 4}});
    json["animations"][0]["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "weights"}}}});
    write("moving.gltf", json.dump());
    view(
        "set panel off\nset at 1\nframes 2\ncapture mid.png\nset at 2\nframes 2\ncapture end.png\n"
        "set at 1.3\nframes 2\ncapture part.png\nsave-view part.json",
        "--vpls 12");
    const std::string still = fmt::format(
        " moving.gltf --size {}x{} --bounces 2 --light-samples 4 --vpls 12 --frames 2 --animate 0:2:1 -o at_#.png",
        kWidth, kHeight);
    ASSERT_EQ(run(program("capture") + still), 0) << textOf("output");
    EXPECT_GT(largestDifference(imageOf("at_1.png"), imageOf("at_2.png")), 20);
    EXPECT_EQ(largestDifference(imageOf("mid.png"), imageOf("at_1.png")), 0);
    EXPECT_EQ(largestDifference(imageOf("end.png"), imageOf("at_2.png")), 0);
    ASSERT_EQ(run(program("capture") + " part.json --frames 2 -o headless.png"), 0) << textOf("output");
    EXPECT_EQ(largestDifference(imageOf("part.png"), imageOf("headless.png")), 0);
}

TEST_F(ViewerAnimation, PlaysPausesAndRefines) {
    view(
        "frames 1\nset speed 2\nset play on\nwait 2\nkey p\nframes 1\nkey p\nwait 6\nreport playing.json\nframes "
        "2\nreport held.json\nset loop off\nset at 1.9\nwait "
        "9\n"
        "report ended.json\nset at 0.25\nframes 3\nreport paused.json",
        "--vpls 4");
    const Json playing = jsonOf("playing.json");
    EXPECT_EQ(playing["animation"]["plays"], true);
    EXPECT_GT(playing["animation"]["at"], 0.3);
    EXPECT_EQ(playing["animation"]["end"], 2.0);
    EXPECT_EQ(playing["frames"], 1) << "every frame shows another moment";
    EXPECT_THAT(jsonOf("held.json")["message"].get<std::string>(), HasSubstr("set play off"));
    EXPECT_EQ(jsonOf("ended.json")["animation"]["plays"], false);
    EXPECT_EQ(jsonOf("ended.json")["animation"]["at"], 2.0);
    EXPECT_EQ(jsonOf("paused.json")["animation"]["at"], 0.25);
    EXPECT_EQ(jsonOf("paused.json")["frames"], 3);
}

TEST_F(ViewerAnimation, LightsThatWereChangedStayWhereTheyAre) {
    view("light 0 brightness 0.5\nset at 1\nframes 1\nsave-view moved.json", "--vpls 4");
    EXPECT_NEAR(jsonOf("moved.json")["lights"][0]["position"][0].get<double>(), -0.8, 1e-5);
}

TEST_F(ViewerAnimation, ASavedViewHoldsTheMoment) {
    view(
        "set panel off\nset at 0.61\nkey w 2\nframes 2\ncapture seen.png\nsave-view view.json\nset at 2\nframes 1\n"
        "open view.json\nframes 2\ncapture opened.png",
        "--vpls 12 --temporal off");
    EXPECT_EQ(jsonOf("view.json")["at"], 0.61);
    ASSERT_EQ(run(program("capture") + " view.json --frames 2 -o headless.png"), 0) << textOf("output");
    EXPECT_EQ(largestDifference(imageOf("seen.png"), imageOf("headless.png")), 0);
    EXPECT_EQ(largestDifference(imageOf("seen.png"), imageOf("opened.png")), 0);
    EXPECT_EQ(jsonOf("end.json")["animation"]["at"], 0.61);
}

TEST_F(ViewerAnimation, StillScenesHaveNone) {
    scene_ = std::string(MANYLIGHT_SOURCE_DIR) + "/scenes/cornell_box.json";
    view("key p\nwait 1\nreport still.json", "--vpls 4");
    EXPECT_FALSE(jsonOf("still.json").contains("animation"));
    EXPECT_THAT(jsonOf("still.json")["message"].get<std::string>(), HasSubstr("nothing moves"));
}

}  // namespace
}  // namespace manylight::test
