// Lights and emission that the viewer changes, takes back and saves.
#include "apps/view_model/light_history.h"
#include "apps/view_model/sidecar_writer.h"
#include "engine/core/file.h"
#include "engine/image/image_io.h"
#include "engine/scene/emission_scale.h"
#include "tests/unit/import_test_support.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace manylight {
namespace {

using ::testing::HasSubstr;

LightState stateOf(float scale) { return {{}, {scale}, false}; }

TEST(LightHistory, TakesStepsBackOneByOne) {
    LightHistory history;
    history.note(stateOf(1.0f), "emission 0", false);
    history.note(stateOf(2.0f), "emission 0", false);
    EXPECT_EQ(history.takeBack()->emissionScales[0], 2.0f);
    EXPECT_EQ(history.takeBack()->emissionScales[0], 1.0f);
    EXPECT_FALSE(history.takeBack().has_value());
}

TEST(LightHistory, ADragIsOneStep) {
    LightHistory history;
    for (const float scale : {1.0f, 2.0f, 3.0f}) history.note(stateOf(scale), "emission 0", true);
    history.note(stateOf(4.0f), "emission 1", true);
    history.letGo();
    history.note(stateOf(5.0f), "emission 1", true);
    EXPECT_EQ(history.steps(), 3u);
    EXPECT_EQ(history.takeBack()->emissionScales[0], 5.0f);
    EXPECT_EQ(history.takeBack()->emissionScales[0], 4.0f);
    EXPECT_EQ(history.takeBack()->emissionScales[0], 1.0f);
}

TEST(LightHistory, ForgetsTheOldestSteps) {
    LightHistory history;
    for (size_t i = 0; i < LightHistory::kMostSteps + 3; ++i) history.note(stateOf(static_cast<float>(i)), "", false);
    EXPECT_EQ(history.steps(), LightHistory::kMostSteps);
    for (size_t i = 1; i < LightHistory::kMostSteps; ++i) history.takeBack();
    EXPECT_EQ(history.takeBack()->emissionScales[0], 3.0f);
}

class ScaledEmission : public testing::SceneFiles {
  protected:
    ScaledEmission() {
        write("a.mtl", "newmtl lamp\nKe 4 2 1\nnewmtl wall\nKd 0.5 0.5 0.5\n");
        write("a.obj", "mtllib a.mtl\nv -1 -1 0\nv 3 -1 0.1\nv -1 1 2\nusemtl lamp\nf 1 2 3\nusemtl wall\nf 1 3 2\n");
    }
    static const Material& lampOf(const Scene& scene) {
        return *std::ranges::find(scene.materials, "lamp", &Material::name);
    }
};

TEST_F(ScaledEmission, MultipliesWhatTheFileGives) {
    const Scene scene = import("a.json", R"({"scene": "a.obj", "emission": {"lamp": 0.25}})");
    EXPECT_EQ(lampOf(scene).emittedRadiance, glm::vec3(1.0f, 0.5f, 0.25f));
    EXPECT_EQ(lampOf(scene).givenRadiance, glm::vec3(4.0f, 2.0f, 1.0f));
    const std::vector<SurfaceEmitter> emitters = surfaceEmitters(scene);
    ASSERT_EQ(emitters.size(), 1u);
    EXPECT_EQ(emitters[0].material, "lamp");
    EXPECT_EQ(emitters[0].scale, 0.25f);
}

TEST_F(ScaledEmission, PutOutIsNotMissing) {
    const Scene scene = import("a.json", R"({"scene": "a.obj", "emission": {"lamp": 0}})");
    EXPECT_EQ(lampOf(scene).emittedRadiance, glm::vec3(0.0f));
    EXPECT_TRUE(scene.lights.empty()) << "no light is given to a scene whose lamp is off";
    EXPECT_EQ(scene.importReport["emissiveTriangles"], 0u);
}

TEST_F(ScaledEmission, MistakesAreNamed) {
    const auto errorWith = [&](const char* emission) {
        return errorOf("a.json", fmt::format(R"({{"scene": "a.obj", "emission": {}}})", emission));
    };
    EXPECT_THAT(errorWith(R"({"lump": 1})"), HasSubstr("a.json: emission.lump: expected the name of a material"));
    EXPECT_THAT(errorWith(R"({"lamp": -1})"), HasSubstr("a.json: emission.lamp: expected a factor in [0, "));
    EXPECT_THAT(errorWith(R"({"lamp": "x"})"), HasSubstr("a.json: emission.lamp"));
    EXPECT_THAT(errorWith("3"), HasSubstr("a.json: emission: expected"));
}

TEST_F(ScaledEmission, IsSavedWithRectanglesRangesAndImages) {
    std::filesystem::create_directories(folder_ / "sub");
    Image sky(2, 1, 3);
    sky.at(1, 0, 2) = 1.0f;
    writeExr(folder_ / "sky.exr", {{"", {"R", "G", "B"}, sky}}, {});
    Scene scene = import("a.json", R"({"scene": "a.obj", "lights": [
        {"type": "rect_area", "center": [0, 0, 2], "u": [1, 0, 0], "v": [0, 1, 0], "radiance": [3, 3, 3]},
        {"type": "point", "position": [1, 2, 3], "intensity": [4, 5, 6], "range": 8},
        {"type": "environment", "image": "sky.exr"}]})");
    ASSERT_TRUE(scaleEmission(scene, "lamp", 0.3f));
    ASSERT_TRUE(scaleEmission(scene, "rect_area 0", 2.0f));
    ASSERT_FALSE(scaleEmission(scene, "wall", 2.0f));
    const std::filesystem::path file = folder_ / "sub" / "b.json";
    writeTextFile(file, sidecarOf({scene, std::nullopt, {64, 48}, {}, true}, file).dump());

    const Scene again = importScene(file);
    ASSERT_EQ(again.materials.size(), scene.materials.size());
    for (size_t i = 0; i < scene.materials.size(); ++i)
        EXPECT_EQ(again.materials[i].emittedRadiance, scene.materials[i].emittedRadiance) << scene.materials[i].name;
    ASSERT_EQ(again.lights.size(), 1u);
    EXPECT_EQ(again.lights[0].range, scene.lights[0].range);
    EXPECT_TRUE(again.environment.has_value());
}

}  // namespace
}  // namespace manylight
