// Estimators that claim to be unbiased show what the path tracer shows: their means over independent seeds agree, and
// would not if one of them were 2 % too bright.
#include "tests/gpu/test_scenes.h"
#include "tests/gpu/z_test.h"

#include <cmath>

namespace manylight::test {
namespace {

constexpr uint32_t kFirstSeedOfTruth = 1000;
constexpr uint32_t kSeeds = 32;  // rare bright samples are judged better by many seeds than by many frames
constexpr double kPlanted = 1.02;

struct Case {
    const char* name;
    Scene (*scene)();
    uint32_t vpls;  // for errors small enough to see the planted factor
    uint32_t frames;
    float bound;  // c that cuts off at least a tenth of the VPLs' light
};

/// Light paths meet 6 surfaces at most, and so do the path tracer's.
RenderSettings pictureSettings(const Case& scene) {
    RenderSettings settings = plainSettings(12, 9);
    settings.castShadows = true;
    settings.russianRoulette = true;
    settings.bounceCount = 6;
    settings.vplCount = scene.vpls;
    settings.lightSampleCount = 16;
    return settings;
}

PictureSamples truthOf(const Scene& scene, RenderSettings settings, uint32_t frames) {
    settings.technique = Technique::PathTracer;
    settings.clamp = ClampMode::Off;
    return samplePictures(scene, settings, {.first = kFirstSeedOfTruth, .count = kSeeds, .frames = frames});
}

/// Forward shading at less expense: it is deferred shading's sum, by other passes.
void expectForwardToAgree(const Scene& scene, RenderSettings settings, const PictureSamples& truth,
                          double largestError) {
    settings.vplCount = 100;
    for (const Technique technique : {Technique::Forward, Technique::ForwardPrepass}) {
        SCOPED_TRACE(name(technique));
        settings.technique = technique;
        // Without a bound a picture has rare bright spots: they ask for seeds, and for frames of each.
        expectSameMeans(samplePictures(scene, settings, {.count = kSeeds, .frames = 4}), truth, largestError);
    }
}

class Unbiased : public GpuTest, public ::testing::WithParamInterface<Case> {};

INSTANTIATE_TEST_SUITE_P(Scenes, Unbiased,
                         ::testing::Values(Case{"CornellBox", cornellBox, 1200, 2, 2.0f},
                                           Case{"EveryKindOfLight", everyKindOfLight, 400, 2, 1.0f},
                                           Case{"SphereInBox", sphereInBox, 800, 2, 3.0f},
                                           Case{"TwoRooms", twoRooms, 1500, 2, 4.0f}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(Unbiased, WithoutABoundAtPixelCentres) {
    const Scene scene = GetParam().scene();
    const RenderSettings settings = pictureSettings(GetParam());
    const PictureSamples truth = truthOf(scene, settings, 48);
    const PictureSamples deferred = samplePictures(scene, settings, {.count = kSeeds, .frames = GetParam().frames});
    expectSameMeans(deferred, truth, 0.0035);
    EXPECT_TRUE(toldApart(scaled(deferred, kPlanted), truth));
    expectForwardToAgree(scene, settings, truth, 0.05);
}

/// Light that was scattered at least twice: edges of lamps that move through pixels would drown the rest in noise.
RenderSettings movingSettings(const Case& scene) {
    RenderSettings settings = pictureSettings(scene);
    settings.width = 24;
    settings.height = 18;
    settings.jitter = true;
    settings.lighting = Lighting::Global;
    settings.vplCount = 200;
    settings.clamp = ClampMode::Compensate;
    settings.clampBound = scene.bound;
    return settings;
}

TEST_P(Unbiased, CompensatedWithMovingSamples) {
    const Scene scene = GetParam().scene();
    RenderSettings settings = movingSettings(GetParam());
    const PictureSamples truth = truthOf(scene, settings, 12);
    expectSameMeans(samplePictures(scene, settings, {.count = kSeeds}), truth, 0.03);
    expectForwardToAgree(scene, settings, truth, 0.05);
    // The same bound without compensation is seen to be biased.
    settings.clamp = ClampMode::Bound;
    settings.clampBound = GetParam().bound / std::pow(static_cast<float>(settings.vplCount), 2.0f / 3.0f);
    EXPECT_TRUE(toldApart(samplePictures(scene, settings, {}), truth));
}

TEST_P(Unbiased, TheBoundTakesMoreThanATenthOfThatLight) {
    const Scene scene = GetParam().scene();
    Renderer renderer(device(), scene, movingSettings(GetParam()), pipelines());
    renderer.keepCutOff(true);
    renderer.renderFrame();
    EXPECT_GT(meanOf(renderer.cutOff()), 0.1 * meanOf(renderer.radiance()));
}

class UnbiasedOnce : public GpuTest {};

TEST_F(UnbiasedOnce, CompensatedAtPixelCentres) {
    const Scene scene = sphereInBox();
    RenderSettings settings = pictureSettings({"", sphereInBox, 800, 0, 0.0f});
    const PictureSamples truth = truthOf(scene, settings, 48);
    settings.clamp = ClampMode::Compensate;
    settings.clampBound = 3.0f;
    const PictureSamples deferred = samplePictures(scene, settings, {.count = kSeeds, .frames = 2});
    expectSameMeans(deferred, truth, 0.0035);
    EXPECT_TRUE(toldApart(scaled(deferred, kPlanted), truth));
}

class LightOfDepth : public GpuTest, public ::testing::WithParamInterface<int> {};

INSTANTIATE_TEST_SUITE_P(Bounces, LightOfDepth, ::testing::Values(0, 1, 2, -1),
                         [](const auto& test) { return test.param < 0 ? "Unlimited" : std::to_string(test.param); });

TEST_P(LightOfDepth, EndsWhereThePathTracersEnds) {
    const Scene scene = sphereInBox();
    RenderSettings settings = pictureSettings({"", sphereInBox, 200, 0, 0.0f});
    settings.bounceCount = GetParam();
    const PictureSamples truth = truthOf(scene, settings, 12);
    expectSameMeans(samplePictures(scene, settings, {.count = kSeeds}), truth, 0.015);
    settings.clamp = ClampMode::Compensate;
    settings.clampBound = 3.0f;
    const PictureSamples compensated = samplePictures(scene, settings, {});
    expectSameMeans(compensated, truth, 0.02);
    // One surface more would be seen.
    if (GetParam() < 0) return;
    ++*settings.bounceCount;
    EXPECT_TRUE(toldApart(compensated, truthOf(scene, settings, 12)));
}

/// Reflections too sharp for a filter to share any of their light.
Scene polished(Scene scene) {
    for (Material& material : scene.materials) {
        material.specular = glm::vec3(0.2f);
        material.roughness = 0.5f;
    }
    return finished(std::move(scene));
}

using UnbiasedInAFilter = GpuTest;

// With a filter every ray to an area light goes to one of several candidates.
TEST_F(UnbiasedInAFilter, LightOfAreaLightsWhereNothingIsShared) {
    for (const auto& scene : {polished(everyKindOfLight()), polished(cornellBox())}) {
        RenderSettings settings = plainSettings(12, 9);
        settings.lighting = Lighting::Local;
        settings.castShadows = true;
        settings.lightSampleCount = 16;
        const PictureSamples truth =
            samplePictures(scene, settings, {.first = kFirstSeedOfTruth, .count = kSeeds, .frames = 16});
        settings.filter = Filter::Atrous;
        settings.interleave = 2;
        const PictureSamples filtered = samplePictures(scene, settings, {.count = kSeeds, .frames = 16});
        expectSameMeans(filtered, truth, 0.0035);
        EXPECT_TRUE(toldApart(scaled(filtered, kPlanted), truth));
    }
}

}  // namespace
}  // namespace manylight::test
