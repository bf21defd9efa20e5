// Scenes and settings with little or nothing in them end in a picture, or in an error that says why not.
#include "engine/core/error.h"
#include "engine/core/finite.h"
#include "engine/scene/normalise.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <cmath>

namespace manylight::test {
namespace {

/// A technique, and what it does about the geometry term where it has one.
struct Way {
    Technique technique;
    ClampMode clamp = ClampMode::Off;
};
constexpr Way kWays[] = {{Technique::Deferred},       {Technique::Deferred, ClampMode::Compensate},
                         {Technique::Forward},        {Technique::Forward, ClampMode::Compensate},
                         {Technique::ForwardPrepass}, {Technique::PathTracer}};

RenderSettings someSettings(const Way& way) {
    RenderSettings settings = plainSettings(16, 12);
    settings.technique = way.technique;
    settings.clamp = way.clamp;
    settings.vplCount = 50;
    settings.bounceCount = -1;
    settings.russianRoulette = true;
    settings.castShadows = true;
    return settings;
}

Scene litBox() {
    Scene scene = closedBox(glm::vec3(0.5f));
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(1.0f)));
    return scene;
}

class Degenerate : public GpuTest, public ::testing::WithParamInterface<Way> {};

INSTANTIATE_TEST_SUITE_P(Techniques, Degenerate, ::testing::ValuesIn(kWays), [](const auto& test) {
    const std::string technique = name(test.param.technique);
    std::string text;
    for (const char letter : technique)
        if (letter != '-') text += letter;
    return text + "_" + name(test.param.clamp);
});

TEST_P(Degenerate, NoLight) { EXPECT_EQ(largestOf(render(closedBox(glm::vec3(0.5f)), someSettings(GetParam()))), 0.0); }

TEST_P(Degenerate, LightsOfNoPower) {
    Scene scene = closedBox(glm::vec3(0.5f));
    scene.lights = {pointLight({}, glm::vec3(0.0f)), constantLight(glm::vec3(0.0f))};
    EXPECT_EQ(largestOf(render(scene, someSettings(GetParam()))), 0.0);
}

TEST_P(Degenerate, NoTriangles) {
    RawScene raw;
    raw.lights.push_back({.type = LightType::Constant, .name = "sky", .emission = glm::dvec3(0.25)});
    raw.lights.push_back({.type = LightType::Point, .name = "lamp", .emission = glm::dvec3(1.0)});
    const Image image = render(normalise(std::move(raw)), someSettings(GetParam()));
    for (const float radiance : image.texels) ASSERT_EQ(radiance, 0.25f);
}

TEST_P(Degenerate, NothingAtAll) {
    RawScene raw;
    raw.lightsAreFinal = true;
    EXPECT_EQ(largestOf(render(normalise(std::move(raw)), someSettings(GetParam()))), 0.0);
}

TEST_P(Degenerate, TheCameraLooksAway) {
    Scene scene = floorFromAbove(0.5f);
    scene.lights = {pointLight({0, 0.2f, 0}, glm::vec3(1.0f)), constantLight({0.5f, 0.25f, 0.125f})};
    scene.cameras.clear();
    addCamera(scene, {0, 0.5f, 0}, {0, 1.5f, 0}, 1.0f);
    const Image image = render(scene, someSettings(GetParam()));
    for (size_t i = 0; i < image.texels.size(); ++i)
        ASSERT_EQ(image.texels[i], i % 3 == 0 ? 0.5f : i % 3 == 1 ? 0.25f : 0.125f);
}

TEST_P(Degenerate, BlackSurfacesLeaveNoVpls) {
    Scene scene = litBox();
    scene.materials[0].albedo = glm::vec3(0.0f);
    Renderer renderer(device(), scene, someSettings(GetParam()), pipelines());
    renderer.renderFrame();
    EXPECT_EQ(renderer.status().vplsTraced, 0u);
    EXPECT_EQ(largestOf(renderer.radiance()), 0.0);
}

TEST_P(Degenerate, NoVplsNoBouncesNoPaths) {
    const Scene scene = litBox();
    RenderSettings settings = someSettings(GetParam());
    settings.lighting = Lighting::Local;
    const Image local = render(scene, settings);
    settings.lighting = Lighting::Both;
    settings.vplCount = 0;
    EXPECT_EQ(sameBits(render(scene, settings), local), settings.technique != Technique::PathTracer) << "has no VPLs";
    settings.vplCount = 50;
    settings.bounceCount = 0;
    EXPECT_TRUE(sameBits(render(scene, settings), local));
    settings.lighting = Lighting::Global;
    EXPECT_EQ(largestOf(render(scene, settings)), 0.0);
}

TEST_P(Degenerate, OneVplOfOnePath) {
    RenderSettings settings = someSettings(GetParam());
    if (settings.technique == Technique::PathTracer) settings.technique = Technique::Deferred;  // which has VPLs
    settings.vplCount = 1;
    settings.bounceCount = 1;
    const VplList list = renderVpls(litBox(), settings);
    EXPECT_EQ(list.status.vplsShaded, 1u);
    EXPECT_EQ(list.vpls.size(), 1u);
}

TEST_P(Degenerate, ThinPictures) {
    for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(1, 2000), glm::uvec2(2000, 1)}) {
        RenderSettings settings = someSettings(GetParam());
        settings.vplCount = 5;
        settings.width = size.x;
        settings.height = size.y;
        const Image image = render(litBox(), settings);
        EXPECT_EQ(image.width, size.x);
        EXPECT_EQ(image.height, size.y);
        EXPECT_GT(meanOf(image), 0.0);
    }
}

TEST_P(Degenerate, OneTriangleEdgeOn) {
    Scene scene;
    addQuad(scene, {-0.5f, 0, -0.5f}, {0, 0, 1}, {1, 0, 0}, addMaterial(scene, glm::vec3(0.5f)));
    scene.triangles.pop_back();
    scene.lights.push_back(pointLight({0, 0.2f, 0}, glm::vec3(1.0f)));
    addCamera(scene, {0, 0, 1}, {0, 0, 0}, 1.0f);
    const Image image = render(finished(std::move(scene)), someSettings(GetParam()));
    for (const float radiance : image.texels) ASSERT_TRUE(hasFiniteBits(radiance));
}

class DegenerateSize : public GpuTest {};

TEST_F(DegenerateSize, LargerThanTheDeviceAllowsIsAnError) {
    const Scene scene = litBox();
    RenderSettings settings = plainSettings();
    settings.width = device().limits().maxImageDimension2D + 1;
    try {
        render(scene, settings);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(std::to_string(settings.width)), std::string::npos) << error.what();
    }
}

TEST_F(DegenerateSize, MoreVplsThanTheDeviceAllowsAreAnError) {
    RenderSettings settings = plainSettings();
    settings.vplCount = UINT32_MAX;
    try {
        render(litBox(), settings);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("--vpls 4294967295"), std::string::npos) << error.what();
    }
}

TEST_F(DegenerateSize, ACameraThatIsNotThereIsAnError) {
    RenderSettings settings = plainSettings();
    settings.camera = 3;
    EXPECT_THROW(render(litBox(), settings), Error);
}

}  // namespace
}  // namespace manylight::test
