// The white furnace: in a closed room whose walls all emit Le and reflect the share a, radiance is Le / (1 - a)
// everywhere and in every direction.
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

namespace manylight::test {
namespace {

/// Pixel centres stay where they are, so the geometry term has finite variance even without a bound.
RenderSettings furnaceSettings() {
    RenderSettings settings = plainSettings(16, 16);
    settings.castShadows = true;
    settings.russianRoulette = true;
    settings.bounceCount = -1;
    settings.vplCount = 1024;
    settings.pathCount = 256;
    settings.lightSampleCount = 512;
    return settings;
}

std::vector<double> furnaceMeans(float albedo, const RenderSettings& settings) {
    std::vector<double> means;
    forEachSeed(closedBox(glm::vec3(albedo), glm::vec3(1.0f)), settings, 16,
                [&](Renderer& renderer) { means.push_back(meanOf(renderer.radiance())); });
    return means;
}

using WhiteFurnace = GpuTest;

TEST_F(WhiteFurnace, HalfReflected) { expectMean(furnaceMeans(0.5f, furnaceSettings()), 2.0, 0.01); }

TEST_F(WhiteFurnace, MostlyReflected) { expectMean(furnaceMeans(0.8f, furnaceSettings()), 5.0, 0.05); }

TEST_F(WhiteFurnace, DirectLightAlone) {
    RenderSettings settings = furnaceSettings();
    settings.lighting = Lighting::Local;
    expectMean(furnaceMeans(0.5f, settings), 1.5, 0.01);
}

TEST_F(WhiteFurnace, OneBounceMore) {
    RenderSettings settings = furnaceSettings();
    settings.russianRoulette = false;
    settings.bounceCount = 1;
    expectMean(furnaceMeans(0.5f, settings), 1.75, 0.01);
}

TEST_F(WhiteFurnace, ForwardShadingToo) {
    RenderSettings settings = furnaceSettings();
    settings.technique = Technique::ForwardPrepass;
    settings.width = settings.height = 8;
    expectMean(furnaceMeans(0.5f, settings), 2.0, 0.02);
}

TEST_F(WhiteFurnace, TheBoundTakesEnergyAndLessOfItWithMorePaths) {
    RenderSettings settings = furnaceSettings();
    settings.castShadows = false;
    settings.clamp = ClampMode::Bound;
    settings.clampBound = 0.01f;
    const Scene scene = closedBox(glm::vec3(0.5f), glm::vec3(1.0f));
    const double tight = meanOf(render(scene, settings));
    settings.clampBound = 0.02f;
    const double looser = meanOf(render(scene, settings));
    settings.clampBound = 1e30f;
    const double none = meanOf(render(scene, settings));
    settings.clamp = ClampMode::Off;
    EXPECT_LT(tight, looser);
    EXPECT_LT(looser, none);
    EXPECT_EQ(none, meanOf(render(scene, settings)));
}

}  // namespace
}  // namespace manylight::test
