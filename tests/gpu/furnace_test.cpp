// The white furnace: in a closed room whose walls all emit Le and reflect the share a, radiance is Le / (1 - a)
// everywhere and in every direction.
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <cmath>

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

std::vector<double> furnaceMeans(float albedo, const RenderSettings& settings, uint32_t frames = 1) {
    std::vector<double> means;
    forEachSeed(
        closedBox(glm::vec3(albedo), glm::vec3(1.0f)), settings, 16,
        [&](Renderer& renderer) { means.push_back(meanOf(renderer.radiance())); }, frames);
    return means;
}

using WhiteFurnace = GpuTest;

TEST_F(WhiteFurnace, HalfReflected) { expectMean(furnaceMeans(0.5f, furnaceSettings()), 2.0, 0.01); }

TEST_F(WhiteFurnace, MostlyReflected) { expectMean(furnaceMeans(0.8f, furnaceSettings()), 5.0, 0.05); }

/// Long paths, and a sample of their very many vertices.
void expectLongPaths(float albedo, ClampMode clamp, double relativeError) {
    RenderSettings settings = furnaceSettings();
    settings.width = settings.height = 8;
    settings.lightSampleCount = 64;
    settings.clamp = clamp;
    const Scene scene = closedBox(glm::vec3(albedo), glm::vec3(1.0f));
    const Renderer renderer(device(), scene, settings, pipelines());
    const int bounces = renderer.settings().bounceCount.value_or(0);
    const double a = double{albedo};
    // Emission, direct light and `bounces` bounces: what unlimited paths would add is left out.
    const double expected = (1.0 - std::pow(a, bounces + 2)) / (1.0 - a);
    expectMean(furnaceMeans(albedo, settings, 2), expected, relativeError * expected);
}

TEST_F(WhiteFurnace, NineTenthsReflected) { expectLongPaths(0.9f, ClampMode::Off, 0.015); }

TEST_F(WhiteFurnace, NinetyNineHundredthsReflected) { expectLongPaths(0.99f, ClampMode::Off, 0.02); }

TEST_F(WhiteFurnace, NinetyNineHundredthsReflectedAndCompensated) {
    expectLongPaths(0.99f, ClampMode::Compensate, 0.03);
}

TEST_F(WhiteFurnace, AllButAThousandthReflected) { expectLongPaths(0.999f, ClampMode::Off, 0.02); }

// Of a bound so low nearly all indirect light is given back; a filter finds nothing to smooth but noise.
TEST_F(WhiteFurnace, HalfReflectedGivenBackAndFiltered) {
    RenderSettings settings = furnaceSettings();
    settings.vplCount = 64;
    settings.lightSampleCount = 64;
    settings.clamp = ClampMode::Compensate;
    settings.clampBound = 0.01f;
    settings.interleave = 4;
    settings.shadowRays = 2;
    for (const Filter filter : {Filter::Atrous, Filter::Ratio}) {
        SCOPED_TRACE(name(filter));
        settings.filter = filter;
        expectMean(furnaceMeans(0.5f, settings, 6), 2.0, 0.02);
    }
}

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
