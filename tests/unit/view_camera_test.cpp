#include "apps/view_model/camera_motion.h"
#include "apps/view_model/sidecar_writer.h"
#include "engine/core/file.h"
#include "tests/unit/import_test_support.h"

#include <cmath>

namespace manylight {
namespace {

constexpr double kHeight = 400.0;  // pixels

CameraPose plainPose() { return {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 45.0}; }

CameraMotion plainMotion() {
    CameraMotion motion;
    motion.reset(plainPose(), 8.0);
    return motion;
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
    EXPECT_LT(glm::length(a - b), 1e-9) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(CameraMotion, AQuarterOfTheSceneASecondAlongTheAxes) {
    CameraMotion motion = plainMotion();
    EXPECT_TRUE(motion.advance({.move = {0, 0, 1}}, Navigation::Fly, 0.5, kHeight));
    expectNear(motion.pose().origin, {0, 0, 4});
    motion.advance({.move = {1, 0, 0}}, Navigation::Fly, 0.5, kHeight);
    expectNear(motion.pose().origin, {1, 0, 4});
    motion.advance({.move = {0, 1, 0}, .fast = true}, Navigation::Fly, 0.5, kHeight);
    expectNear(motion.pose().origin, {1, 4, 4});
    expectNear(motion.pose().target - motion.pose().origin, {0, 0, -5});
}

TEST(CameraMotion, NothingAskedIsNothingMoved) {
    CameraMotion motion = plainMotion();
    EXPECT_FALSE(motion.advance({}, Navigation::Fly, 1.0, kHeight));
    EXPECT_FALSE(motion.advance({.wheel = 1.0}, Navigation::Fly, 1.0, kHeight)) << "flying, the wheel sets the speed";
    EXPECT_DOUBLE_EQ(motion.speed(), 2.0 * 1.25);
    expectNear(motion.pose().origin, plainPose().origin);
}

TEST(CameraMotion, FlyingTurnsTheViewAndOrbitingKeepsTheTarget) {
    CameraMotion flying = plainMotion();
    const double right = glm::radians(90.0) / 2.0 * kHeight;  // pixels for a quarter turn
    flying.advance({.turn = {right, 0}}, Navigation::Fly, 0.1, kHeight);
    expectNear(flying.pose().origin, {0, 0, 5});
    expectNear(flying.pose().target, {5, 0, 5});

    CameraMotion orbiting = plainMotion();
    orbiting.advance({.turn = {right, 0}}, Navigation::Orbit, 0.1, kHeight);
    expectNear(orbiting.pose().target, {0, 0, 0});
    expectNear(orbiting.pose().origin, {-5, 0, 0});
    orbiting.advance({.wheel = 2.0}, Navigation::Orbit, 0.1, kHeight);
    expectNear(orbiting.pose().origin, {-5 * 0.81, 0, 0});
}

TEST(CameraMotion, TheViewStopsShortOfThePoles) {
    CameraMotion motion = plainMotion();
    for (int i = 0; i < 10; ++i) motion.advance({.turn = {0, 500}}, Navigation::Fly, 0.1, kHeight);
    const glm::dvec3 forward = glm::normalize(motion.pose().target - motion.pose().origin);
    EXPECT_NEAR(forward.y, -1.0, 1e-3);
    EXPECT_LT(forward.z, 0.0) << "not turned over";
    motion.advance({.move = {1, 0, 0}}, Navigation::Fly, 0.5, kHeight);
    EXPECT_GT(motion.pose().origin.x, 0.9) << "right is still right";
}

TEST(CameraMotion, NothingLeadsOutOfTheWorldOrIntoAPoint) {
    CameraMotion motion = plainMotion();
    for (int i = 0; i < 2000; ++i)
        motion.advance({.move = {0, 0, -1}, .wheel = 5, .fast = true}, Navigation::Fly, 1.0, kHeight);
    const double away = glm::length(motion.pose().origin - plainPose().origin);
    EXPECT_GT(away, 1e3);
    EXPECT_LE(away, 1e4 * 8.0);
    expectNear(motion.pose().target - motion.pose().origin, {0, 0, -5});
    for (int i = 0; i < 2000; ++i) motion.advance({.wheel = 9}, Navigation::Orbit, 1.0, kHeight);
    EXPECT_NEAR(glm::length(motion.pose().target - motion.pose().origin), 1e-5 * 8.0, 1e-9);
}

TEST(CameraMotion, PanningMovesWhatIsLookedAtWithTheMouse) {
    CameraMotion motion = plainMotion();
    const double perPixel = 2.0 * 5.0 * std::tan(glm::radians(22.5)) / kHeight;
    motion.advance({.pan = {10, 20}}, Navigation::Orbit, 0.1, kHeight);
    expectNear(motion.pose().target, {-10 * perPixel, 20 * perPixel, 0});
}

const char* const kTriangle = "v -1 -1 0\nv 3 -1 0.1\nv -1 1 2\nf 1 2 3\n";

using SavedView = testing::SceneFiles;

TEST_F(SavedView, IsTheSameCameraToTheBitWhenItIsOpened) {
    const Scene scene = import("a.obj", kTriangle);
    CameraMotion motion;
    motion.reset(poseOf(scene.cameras.front(), scene.frame), 3.0);
    motion.advance({.move = {0.3, 0.1, 0.7}, .turn = {33, 21}}, Navigation::Fly, 0.123, kHeight);
    const std::filesystem::path file = folder_ / "sub" / "view.json";
    std::filesystem::create_directories(file.parent_path());
    writeTextFile(file, sidecarOf({scene, motion.pose(), {64, 48}, {}, false}, file).dump());

    const Scene again = importScene(file);
    const Camera expected = cameraOf(motion.pose(), scene.frame);
    EXPECT_EQ(again.cameras.front().origin, expected.origin);
    EXPECT_EQ(again.cameras.front().forward, expected.forward);
    EXPECT_EQ(again.cameras.front().up, expected.up);
    EXPECT_EQ(again.cameras.front().verticalFov, expected.verticalFov);
    EXPECT_EQ(again.cameras.front().resolution, glm::uvec2(64, 48));
    EXPECT_NE(expected.origin, scene.cameras.front().origin);
}

TEST_F(SavedView, KeepsWhatTheSidecarSaysOfOtherThings) {
    write("a.obj", kTriangle);
    const Scene scene = import("a.json", R"({"scene": "a.obj", "name": "mine", "max_depth": 3, "lights": [
        {"type": "point", "name": "lamp", "position": [1, 2, 3], "intensity": [4, 5, 6]},
        {"type": "rect_area", "center": [0, 0, 2], "u": [1, 0, 0], "v": [0, 1, 0], "radiance": [1, 1, 1]}]})");
    Scene changed = scene;
    changed.lights.front().emission *= 0.5f;
    RenderSettings settings;
    settings.vplCount = 77;
    settings.width = 64;
    settings.height = 48;
    const std::filesystem::path file = folder_ / "b.json";
    writeTextFile(file, sidecarOf({changed, std::nullopt, {64, 48}, settings, true}, file).dump());

    const Scene again = importScene(file);
    EXPECT_EQ(again.name, "mine");
    EXPECT_EQ(again.maxDepth, 3);
    EXPECT_EQ(again.triangles.size(), scene.triangles.size()) << "the rectangle is still there, once";
    ASSERT_EQ(again.lights.size(), 1u);
    EXPECT_EQ(again.lights.front().name, "lamp");
    EXPECT_LT(glm::length(again.lights.front().emission - changed.lights.front().emission), 1e-6f);
    EXPECT_LT(glm::length(again.lights.front().position - changed.lights.front().position), 1e-6f);
    RenderSettings loaded;
    applySettings(loaded, again.settings, "b.json");
    EXPECT_EQ(loaded, settings);
}

TEST_F(SavedView, WritesEveryKindOfLightAsTheImporterReadsIt) {
    const std::string lights = R"([
        {"type": "spot", "position": [1, 0, 1], "direction": [0, 0, -1], "cutoff_deg": 40, "beam_deg": 10,
         "intensity": [1, 2, 3]},
        {"type": "directional", "direction": [0, -1, 0], "irradiance": [1, 1, 2]},
        {"type": "constant", "radiance": [0.5, 0.25, 0.125]}])";
    write("a.obj", kTriangle);
    const Scene scene = import("a.json", R"({"scene": "a.obj", "lights": )" + lights + "}");
    const std::filesystem::path file = folder_ / "b.json";
    writeTextFile(file, sidecarOf({scene, std::nullopt, {64, 48}, {}, true}, file).dump());
    const Scene again = importScene(file);
    ASSERT_EQ(again.lights.size(), 3u);
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(again.lights[i].type, scene.lights[i].type);
        EXPECT_LT(glm::length(again.lights[i].emission - scene.lights[i].emission), 1e-6f);
        EXPECT_LT(glm::length(again.lights[i].direction - scene.lights[i].direction), 1e-6f);
        EXPECT_NEAR(again.lights[i].cosCutoff, scene.lights[i].cosCutoff, 1e-6f);
        EXPECT_NEAR(again.lights[i].cosBeam, scene.lights[i].cosBeam, 1e-6f);
    }
}

}  // namespace
}  // namespace manylight
