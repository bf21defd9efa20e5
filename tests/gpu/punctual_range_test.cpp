// Lights of limited range: what they send to the first surface is windowed, and what that reflects is not.
#include "tests/gpu/test_scenes.h"
#include "tests/gpu/z_test.h"

namespace manylight::test {
namespace {

Scene rangedRoom() {
    Scene scene = unevenBox();
    scene.lights = {pointLight({0.1f, 0.2f, 0.05f}, {0.5f, 0.4f, 0.3f}),
                    spotLight({-0.3f, 0.4f, -0.1f}, {0.5f, -1.0f, -0.2f}, {1.0f, 1.5f, 2.0f}, 0.3f, 0.7f)};
    scene.lights[0].range = 0.7f;
    scene.lights[1].range = 1.1f;
    return scene;
}

using LightRange = GpuTest;

TEST_F(LightRange, LightPathsAndPathsFromTheCameraAgree) {
    const Scene scene = rangedRoom();
    RenderSettings settings = plainSettings(12, 9);
    settings.castShadows = true;
    settings.bounceCount = 3;
    settings.vplCount = 500;
    constexpr uint32_t kSeeds = 24;
    RenderSettings reference = settings;
    reference.technique = Technique::PathTracer;
    const PictureSamples truth = samplePictures(scene, reference, {.first = 1000, .count = kSeeds, .frames = 24});
    const PictureSamples deferred = samplePictures(scene, settings, {.count = kSeeds, .frames = 2});
    expectSameMeans(deferred, truth, 0.006);
    EXPECT_TRUE(toldApart(scaled(deferred, 1.03), truth));
    Scene unlimited = scene;
    for (Light& light : unlimited.lights) light.range = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(toldApart(deferred, samplePictures(unlimited, reference, {.count = kSeeds, .frames = 4})));
}

TEST_F(LightRange, ALightThatReachesNothingLeavesNoVpls) {
    Scene scene = rangedRoom();
    for (Light& light : scene.lights) light.range = 0.05f;
    RenderSettings settings = plainSettings();
    settings.bounceCount = 3;
    settings.vplCount = 100;
    EXPECT_EQ(renderVpls(scene, settings).status.vplsTraced, 0u);
}

}  // namespace
}  // namespace manylight::test
