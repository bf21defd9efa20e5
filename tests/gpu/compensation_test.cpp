// What the bound on the geometry term takes is known, and what compensation gives back is that.
#include "engine/core/statistics.h"
#include "tests/gpu/test_scenes.h"
#include "tests/gpu/z_test.h"
#include "tests/support/significance.h"

#include <cmath>

namespace manylight::test {
namespace {

RenderSettings compensatedSettings(float bound, uint32_t vpls, int bounces, uint32_t width = 12, uint32_t height = 9) {
    RenderSettings settings = plainSettings(width, height);
    settings.castShadows = true;
    settings.russianRoulette = true;
    settings.bounceCount = bounces;
    settings.vplCount = vpls;
    settings.clamp = ClampMode::Compensate;
    settings.clampBound = bound;
    return settings;
}

/// The same bound on G in the first frame, without compensation.
RenderSettings merelyBounded(RenderSettings settings) {
    const auto paths = static_cast<float>(settings.pathCount > 0 ? settings.pathCount : settings.vplCount);
    settings.clamp = ClampMode::Bound;
    settings.clampBound = *settings.clampBound / std::pow(paths, 2.0f / 3.0f);
    return settings;
}

PictureSamples truthOf(const Scene& scene, RenderSettings settings, uint32_t frames) {
    settings.technique = Technique::PathTracer;
    settings.clamp = ClampMode::Off;
    return samplePictures(scene, settings, {.first = 1000, .frames = frames});
}

using Compensation = GpuTest;

TEST_F(Compensation, GivesBackEverythingWhereTheBoundLeavesNothing) {
    const Scene scene = unevenBox();
    for (const float bound : {0.0f, 1e-3f}) {
        SCOPED_TRACE(bound);
        RenderSettings settings = compensatedSettings(bound, 4, 3);
        settings.lighting = Lighting::Global;
        const PictureSamples truth = truthOf(scene, settings, 32);
        const PictureSamples compensated = samplePictures(scene, settings, {.frames = 24});
        expectSameMeans(compensated, truth, 0.012);
        EXPECT_TRUE(toldApart(scaled(compensated, 1.05), truth));
    }
}

TEST_F(Compensation, AsksVplsForWhatTheBoundLeavesThem) {
    // The bound takes a part, and where short paths end VPLs give a share of the light.
    const Scene scene = unevenBox();
    RenderSettings settings = compensatedSettings(5.0f, 100, 3);
    settings.lighting = Lighting::Global;
    const PictureSamples truth = truthOf(scene, settings, 32);
    const PictureSamples compensated = samplePictures(scene, settings, {.frames = 24});
    expectSameMeans(compensated, truth, 0.012);
    EXPECT_TRUE(toldApart(scaled(compensated, 1.03), truth));
}

TEST_F(Compensation, OfABoundThatTakesNothingIsNothing) {
    const Scene scene = everyKindOfLight();
    for (const Technique technique : {Technique::Deferred, Technique::Forward, Technique::ForwardPrepass}) {
        RenderSettings settings = compensatedSettings(1e30f, 100, 4, 24, 18);
        settings.technique = technique;
        settings.jitter = true;
        const Image compensated = render(scene, settings, 2);
        settings.clamp = ClampMode::Off;
        const Image whole = render(scene, settings, 2);
        if (technique == Technique::Deferred) {
            EXPECT_TRUE(sameBits(compensated, whole));
        }
        // Forward shading has one shader with and one without: what they share may be compiled to round differently.
        for (size_t i = 0; i < whole.texels.size(); ++i)
            ASSERT_NEAR(compensated.texels[i], whole.texels[i], 2e-6f * whole.texels[i]) << name(technique);
    }
}

TEST_F(Compensation, WhatTheBoundTakesAndWhatItLeavesMakeTheWhole) {
    const Scene scene = everyKindOfLight();
    RenderSettings settings = merelyBounded(compensatedSettings(1.0f, 100, 4, 24, 18));
    Renderer renderer(device(), scene, settings, pipelines());
    renderer.keepCutOff(true);
    for (int frame = 0; frame < 2; ++frame) renderer.renderFrame();
    const Image bounded = renderer.radiance();
    const Image cutOff = renderer.cutOff();
    settings.clamp = ClampMode::Off;
    const Image whole = render(scene, settings, 2);
    EXPECT_GT(meanOf(cutOff), 0.01 * meanOf(whole));
    // Sums of a hundred terms, each to rounding.
    for (size_t i = 0; i < whole.texels.size(); ++i)
        ASSERT_NEAR(bounded.texels[i] + cutOff.texels[i], whole.texels[i], 2e-6f * (1.0f + whole.texels[i])) << i;
}

TEST_F(Compensation, APictureLacksWhatTheBoundTook) {
    const Scene scene = sphereInBox();
    RenderSettings settings = merelyBounded(compensatedSettings(1.0f, 300, 4));
    settings.lighting = Lighting::Global;
    const Estimate truth = estimate(truthOf(scene, settings, 48).mean);
    std::vector<double> bounded;
    std::vector<double> cutOff;
    Renderer renderer(device(), scene, settings, pipelines());
    renderer.keepCutOff(true);
    for (settings.seed = 0; settings.seed < 16; ++settings.seed) {
        renderer.restart(settings);
        for (int frame = 0; frame < 4; ++frame) renderer.renderFrame();
        bounded.push_back(meanOf(renderer.radiance()));
        cutOff.push_back(meanOf(renderer.cutOff()));
    }
    const double lacking = truth.mean - estimate(bounded).mean;
    const double error = std::hypot(truth.error, estimate(bounded).error, estimate(cutOff).error);
    EXPECT_GT(lacking, 20.0 * error);
    EXPECT_NEAR(lacking, estimate(cutOff).mean, 5.0 * error);
}

class ConcaveEdge : public GpuTest, public ::testing::WithParamInterface<float> {};

INSTANTIATE_TEST_SUITE_P(Distances, ConcaveEdge, ::testing::Values(0.1f, 0.01f, 0.001f));

TEST_P(ConcaveEdge, IsDarkWithABoundAndRightWithCompensation) {
    // Floor points half to one and a half times the distance from the wall.
    const float distance = GetParam();
    Scene scene = unevenBox();
    scene.cameras.clear();
    const glm::vec3 eye(-0.2f, 0.0f, 0.0f);
    const glm::vec3 target(-0.5f + distance, -0.5f, 0.0f);
    addCamera(scene, eye, target, distance / glm::length(target - eye));
    scene = finished(std::move(scene));
    RenderSettings settings = compensatedSettings(20.0f, 150, 2);
    settings.jitter = true;
    settings.lighting = Lighting::Global;
    const PictureSamples truth = truthOf(scene, settings, 32);
    expectSameMeans(samplePictures(scene, settings, {.frames = 4}), truth, 0.015);
    EXPECT_TRUE(toldApart(samplePictures(scene, merelyBounded(settings), {.count = 64, .frames = 4}), truth));
}

}  // namespace
}  // namespace manylight::test
