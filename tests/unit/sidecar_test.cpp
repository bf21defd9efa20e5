#include "tests/unit/import_test_support.h"

#include <gmock/gmock.h>

namespace manylight::testing {
namespace {

using ::testing::HasSubstr;

class Sidecar : public SceneFiles {
  protected:
    Sidecar() { write("models/room.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n"); }

    /// The Error for a sidecar with these further keys.
    std::string errorWith(const std::string& keys) const {
        return errorOf("room.json", R"({"scene": "models/room.obj", )" + keys + "}");
    }
};

TEST_F(Sidecar, GivesCameraLightsDepthAndSettings) {
    const Scene scene = import("room.json", R"({
        "name": "room", "scene": "models/room.obj", "max_depth": 3,
        "camera": {"origin": [0, 1, 8], "target": [0, 1, 0], "up": [0, 2, 0], "fov_y_deg": 60, "width": 320, "height": 240},
        "lights": [
            {"type": "point", "position": [2, 2, 2], "intensity": [4, 5, 6], "range": 3},
            {"type": "spot", "position": [0, 0, 1], "direction": [0, 0, -2], "cutoff_deg": 60, "beam_deg": 45, "intensity": [1, 1, 1]},
            {"type": "directional", "direction": [0, -3, 0], "irradiance": [1, 2, 3]},
            {"type": "constant", "name": "sky", "radiance": [0.5, 0.5, 0.5]},
            {"type": "rect_area", "center": [0, 0, 3], "u": [1, 0, 0], "v": [0, 1, 0], "radiance": [9, 9, 9]}],
        "settings": {"vpls": 100}})");
    EXPECT_EQ(scene.name, "room");
    EXPECT_EQ(scene.maxDepth, 3);
    EXPECT_EQ(scene.settings["vpls"], 100);
    EXPECT_EQ(scene.triangles.size(), 3u);
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].forward, glm::vec3(0, 0, -1));
    EXPECT_EQ(scene.cameras[0].up, glm::vec3(0, 1, 0));
    EXPECT_NEAR(scene.cameras[0].verticalFov, 1.0471976f, 1e-6f);
    EXPECT_EQ(scene.cameras[0].resolution, glm::uvec2(320, 240));
    ASSERT_EQ(scene.lights.size(), 4u);
    EXPECT_NEAR(scene.lights[0].emission.y, std::ldexp(5.0f, -2 * scene.frame.exponent), 1e-7f);
    EXPECT_EQ(scene.lights[0].range, std::ldexp(3.0f, -scene.frame.exponent));
    EXPECT_EQ(scene.lights[1].range, std::numeric_limits<float>::infinity());
    EXPECT_NEAR(scene.lights[1].cosCutoff, 0.5f, 1e-6f);
    EXPECT_NEAR(scene.lights[1].cosBeam, 0.70710678f, 1e-6f);
    EXPECT_EQ(scene.lights[2].direction, glm::vec3(0, -1, 0));
    EXPECT_EQ(scene.lights[2].emission, glm::vec3(1, 2, 3));
    EXPECT_EQ(scene.lights[3].type, LightType::Constant);
    EXPECT_EQ(scene.lights[3].name, "sky");
    EXPECT_EQ(scene.importReport["emissiveTriangles"], 2u);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.toText();
}

TEST_F(Sidecar, EmptyListOfLightsIsRespected) {
    EXPECT_TRUE(import("a.json", R"({"scene": "models/room.obj", "lights": []})").lights.empty());
    EXPECT_EQ(import("b.json", R"({"scene": "models/room.obj"})").lights.size(), 1u);
}

TEST_F(Sidecar, UnknownKeysAreNamedWithTheirPath) {
    EXPECT_THAT(errorWith(R"("light": [])"), HasSubstr("room.json: light: unknown key, expected one of name, scene"));
    EXPECT_THAT(errorWith(R"("lights": [{"type": "constant", "radiance": [1, 1, 1]},
                                        {"type": "constant", "radience": [1, 1, 1]}])"),
                HasSubstr("room.json: lights[1].radience: unknown key, expected one of type, name, radiance"));
    EXPECT_THAT(errorWith(R"("camera": {"origin": [0,0,0], "target": [0,0,1], "fov": 4})"),
                HasSubstr("camera.fov: unknown"));
}

TEST_F(Sidecar, WrongValuesAreNamedWithTheirPath) {
    const std::pair<const char*, const char*> cases[] = {
        {R"("max_depth": 0)", "max_depth: expected -1 (unlimited) or at least 1"},
        {R"("max_depth": 1.5)", "max_depth: expected an integer"},
        {R"("name": 7)", "name: expected a text, found 7"},
        {R"("lights": {})", "lights: expected an array"},
        {R"("lights": [7])", "lights[0]: expected an object"},
        {R"("lights": [{"type": "lamp"}])", "lights[0].type: expected point, spot"},
        {R"("lights": [{"type": "point", "position": [0, 0], "intensity": [1, 1, 1]}])",
         "lights[0].position: expected three"},
        {R"("lights": [{"type": "point", "position": [0, 0, 0]}])", "lights[0]: missing key \"intensity\""},
        {R"("lights": [{"type": "point", "position": [0, 0, 0], "intensity": [1, -1, 1]}])", "none negative"},
        {R"("lights": [{"type": "point", "position": [0, 0, "a"], "intensity": [1, 1, 1]}])",
         "lights[0].position[2]: expected a finite"},
        {R"("lights": [{"type": "point", "position": [0, 0, 0], "intensity": [1, 1, 1], "range": 0}])",
         "lights[0].range: expected a number above zero"},
        {R"("lights": [{"type": "directional", "direction": [0, 0, 0], "irradiance": [1, 1, 1]}])", "not zero"},
        {R"("lights": [{"type": "spot", "position": [0,0,0], "direction": [0,0,1], "cutoff_deg": 30, "beam_deg": 40, "intensity": [1,1,1]}])",
         "lights[0].beam_deg: expected an angle no larger"},
        {R"("lights": [{"type": "rect_area", "center": [0,0,0], "u": [1,0,0], "v": [2,0,0], "radiance": [1,1,1]}])",
         "not parallel"},
        {R"("camera": {"origin": [0,0,0], "target": [0,0,0], "fov_y_deg": 40})",
         "camera.target: expected a point other than"},
        {R"("camera": {"origin": [0,0,0], "target": [0,1,0], "fov_y_deg": 40})", "camera: expected an up vector"},
        {R"("camera": {"origin": [0,0,0], "target": [0,0,1], "fov_y_deg": 180})", "camera.fov_y_deg: expected degrees"},
        {R"("camera": {"origin": [0,0,0], "target": [0,0,1], "fov_y_deg": 40, "width": 10})", "missing key \"height\""},
        {R"("camera": {"origin": [0,0,0], "target": [0,0,1], "fov_y_deg": 40, "width": 0, "height": 1})",
         "camera.width: expected an integer"},
        {R"("use_gltf_lights": 1)", "use_gltf_lights: expected true or false"},
        {R"("settings": [])", "settings: expected an object"},
        {R"("max_depth": 1e999)", "room.json: not valid JSON"},
    };
    for (const auto& [keys, message] : cases) EXPECT_THAT(errorWith(keys), HasSubstr(message)) << keys;
}

TEST_F(Sidecar, MustNameASceneThatExists) {
    EXPECT_THAT(errorOf("a.json", "{}"), HasSubstr("missing key \"scene\""));
    EXPECT_THAT(errorOf("a.json", R"({"scene": "none.obj"})"), HasSubstr("scene: expected an existing file"));
    EXPECT_THAT(errorOf("a.json", R"({"scene": "a.json"})"), HasSubstr("not another sidecar"));
    EXPECT_THAT(errorOf("a.json", R"({"scene": "models"})"), HasSubstr("unknown kind of scene"));
    EXPECT_THAT(errorOf("a.json", "[]"), HasSubstr("expected an object"));
    EXPECT_THAT(errorOf("a.json", std::string(5000, '[')), HasSubstr("nested deeper"));
}

TEST_F(Sidecar, UnknownExtensionsListTheKnownOnes) {
    EXPECT_THAT(errorOf("a.fbx", ""), HasSubstr("a.fbx: unknown kind of scene, expected .obj, .gltf, .glb"));
}

TEST_F(Sidecar, SurvivesEveryTruncation) {
    const std::string text = R"({"scene": "models/room.obj", "lights": [{"type": "constant", "radiance": [1, 1, 1]}]})";
    for (size_t size = 0; size < text.size(); ++size)
        EXPECT_THAT(errorOf("cut.json", std::string_view(text).substr(0, size)), HasSubstr("not valid JSON")) << size;
}

}  // namespace
}  // namespace manylight::testing
