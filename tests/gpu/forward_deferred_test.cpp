// Forward and deferred shading call the same functions and differ in where their surfaces come from: their pictures
// agree up to the G-buffer's rounding.
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <cmath>

namespace manylight::test {
namespace {

/// The G-buffer keeps albedos in steps of 2^-21, which is 2.4e-6 of an albedo of 0.1, the smallest here; its normal is
/// off by rounding, which counts where light arrives at grazing angles: hence a share of the picture's mean.
void expectSamePicture(const Image& forward, const Image& deferred) {
    ASSERT_EQ(forward.texels.size(), deferred.texels.size());
    const double mean = meanOf(deferred);
    for (size_t i = 0; i < forward.texels.size(); ++i) {
        const double expected = double{deferred.texels[i]};
        ASSERT_NEAR(double{forward.texels[i]}, expected, 1e-5 * (expected + 0.1 * mean))
            << "channel " << i % 3 << " of pixel " << i / 3 % forward.width << ", " << i / 3 / forward.width;
    }
}

void expectTechniquesAgree(const Scene& scene, RenderSettings settings, uint32_t frames = 1) {
    settings.technique = Technique::Deferred;
    const Image deferred = render(scene, settings, frames);
    for (const Technique technique : {Technique::Forward, Technique::ForwardPrepass}) {
        SCOPED_TRACE(name(technique));
        settings.technique = technique;
        expectSamePicture(render(scene, settings, frames), deferred);
    }
}

RenderSettings pictureSettings(uint32_t vpls, bool shadows) {
    RenderSettings settings = plainSettings(48, 36);
    settings.vplCount = vpls;
    settings.bounceCount = -1;
    settings.russianRoulette = true;
    settings.castShadows = shadows;
    return settings;
}

class ForwardDeferred : public GpuTest, public ::testing::WithParamInterface<uint32_t> {};

/// 130 and 300 do not fit one padded block, 300 and 1100 not one dispatch or draw.
INSTANTIATE_TEST_SUITE_P(VplCounts, ForwardDeferred, ::testing::Values(0u, 1u, 7u, 130u, 300u, 1100u));

TEST_P(ForwardDeferred, CornellBox) {
    const Scene scene = cornellBox();
    for (const bool shadows : {false, true}) expectTechniquesAgree(scene, pictureSettings(GetParam(), shadows));
}

TEST_P(ForwardDeferred, TexturesSmoothNormalsAndEveryKindOfLight) {
    const Scene scene = everyKindOfLight();
    for (const bool shadows : {false, true}) expectTechniquesAgree(scene, pictureSettings(GetParam(), shadows));
}

class ForwardDeferredOnce : public GpuTest {};

TEST_F(ForwardDeferredOnce, AnySize) {
    const Scene scene = everyKindOfLight();
    for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(17, 5), glm::uvec2(33, 9)}) {
        RenderSettings settings = pictureSettings(20, true);
        settings.width = size.x;
        settings.height = size.y;
        expectTechniquesAgree(scene, settings);
    }
}

TEST_F(ForwardDeferredOnce, LocalGlobalAndJitteredFrames) {
    const Scene scene = everyKindOfLight();
    RenderSettings settings = pictureSettings(50, true);
    settings.jitter = true;
    for (const Lighting lighting : {Lighting::Local, Lighting::Global, Lighting::Both}) {
        SCOPED_TRACE(name(lighting));
        settings.lighting = lighting;
        expectTechniquesAgree(scene, settings, 3);
    }
}

TEST_F(ForwardDeferredOnce, ManySamplesOfAreaLightsTakeSeveralDraws) {
    RenderSettings settings = pictureSettings(200, true);
    settings.lightSampleCount = 600;
    expectTechniquesAgree(everyKindOfLight(), settings);
}

TEST_F(ForwardDeferredOnce, TheSameTriangleTwiceIsSeenOnce) {
    // The first of equals wins.
    Scene scene = floorFromAbove(0.5f);
    addQuad(scene, {-0.5f, 0, -0.5f}, {0, 0, 1}, {1, 0, 0}, addMaterial(scene, {0.2f, 0.9f, 0.3f}));
    scene.lights.push_back(pointLight({0.1f, 0.5f, 0.1f}, glm::vec3(1.0f)));
    for (const bool shadows : {false, true}) {
        // With shadows 300 VPLs take two draws, and neither may count the twin.
        RenderSettings settings = pictureSettings(300, shadows);
        const Image deferred = render(scene, settings);
        for (const Technique technique : {Technique::Forward, Technique::ForwardPrepass}) {
            settings.technique = technique;
            expectSamePicture(render(scene, settings), deferred);
        }
    }
}

TEST_F(ForwardDeferredOnce, LightAndGlobalMakeBoth) {
    const Scene scene = cornellBox();
    RenderSettings settings = pictureSettings(100, true);
    const Image both = render(scene, settings);
    settings.lighting = Lighting::Local;
    const Image local = render(scene, settings);
    settings.lighting = Lighting::Global;
    const Image global = render(scene, settings);
    EXPECT_GT(meanOf(local), 0.0);
    EXPECT_GT(meanOf(global), 0.0);
    for (size_t i = 0; i < both.texels.size(); ++i)
        ASSERT_NEAR(both.texels[i], local.texels[i] + global.texels[i], 1e-6f * (1.0f + both.texels[i])) << i;
}

}  // namespace
}  // namespace manylight::test
