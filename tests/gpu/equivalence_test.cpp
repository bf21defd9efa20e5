// The equivalence matrix: what must not matter does not show, in the bytes, to rounding, or in expectation. A line of a
// table each.
#include "engine/techniques/gbuffer_capture.h"
#include "engine/techniques/ray_caster.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <cmath>
#include <numeric>
#include <ostream>

namespace manylight::test {
namespace {

using Change = void (*)(RenderSettings&);

RenderSettings matrixSettings(uint32_t size = 16) {
    RenderSettings settings = plainSettings(size, size);
    settings.vplCount = 150;
    settings.bounceCount = -1;
    settings.russianRoulette = true;
    settings.castShadows = true;
    settings.seed = 1;
    return settings;
}

RenderSettings changed(RenderSettings settings, Change change) {
    change(settings);
    return settings;
}

/// Two settings, and what a failure calls them.
struct Pair {
    const char* name;
    Change left;
    Change right;
};

/// What GoogleTest prints in place of the bytes.
void PrintTo(const Pair& pair, std::ostream* stream) { *stream << pair.name; }

std::string nameOf(const ::testing::TestParamInfo<Pair>& info) { return info.param.name; }

void unchanged(RenderSettings&) {}
void compensated(RenderSettings& settings) { settings.clamp = ClampMode::Compensate; }
void pathTraced(RenderSettings& settings) { settings.technique = Technique::PathTracer; }
void forward(RenderSettings& settings) { settings.technique = Technique::Forward; }

class SameBytes : public GpuTest, public ::testing::WithParamInterface<Pair> {};

INSTANTIATE_TEST_SUITE_P(
    Equivalence, SameBytes,
    ::testing::Values(Pair{"Repeated", unchanged, unchanged}, Pair{"CompensatedRepeated", compensated, compensated},
                      Pair{"PathTracedRepeated", pathTraced, pathTraced},
                      Pair{"NothingLeftOut", unchanged, [](RenderSettings& s) { s.plan = false; }},
                      Pair{"NothingLeftOutPathTraced", pathTraced,
                           [](RenderSettings& s) {
                               pathTraced(s);
                               s.plan = false;
                           }},
                      Pair{"ABoundThatCutsNothing", unchanged,
                           [](RenderSettings& s) {
                               s.clamp = ClampMode::Bound;
                               s.clampBound = 1e30f;
                           }},
                      Pair{"EveryPassLookedAt", unchanged, [](RenderSettings& s) { s.checkFinite = true; }},
                      Pair{"OtherToneCurve", unchanged,
                           [](RenderSettings& s) {
                               s.toneCurve = ToneCurve::Linear;
                               s.exposure = 3.0f;
                           }}),
    nameOf);

TEST_P(SameBytes, OfTwoFrames) {
    for (const Scene& scene : {cornellBox(), everyKindOfLight()}) {
        const Image left = render(scene, changed(matrixSettings(), GetParam().left), 2);
        EXPECT_GT(meanOf(left), 0.0);
        EXPECT_TRUE(sameBits(left, render(scene, changed(matrixSettings(), GetParam().right), 2)));
    }
}

using EquivalenceOnce = GpuTest;

TEST_F(EquivalenceOnce, WhatIsKeptBesidesDoesNotShow) {
    const Scene scene = cornellBox();
    const Image plain = render(scene, matrixSettings(), 2);
    Renderer renderer(device(), scene, matrixSettings(), pipelines());
    renderer.keepVpls();
    renderer.keepVariance(true);
    renderer.keepCutOff(true);
    renderer.renderFrame();
    renderer.renderFrame();
    EXPECT_TRUE(sameBits(renderer.radiance(), plain));
}

TEST_F(EquivalenceOnce, TwiceTheLightIsTwiceThePicture) {
    for (const Change change : {unchanged, compensated, pathTraced, forward}) {
        Scene scene = everyKindOfLight();
        const Image once = render(scene, changed(matrixSettings(), change), 2);
        for (Material& material : scene.materials) material.emittedRadiance *= 2.0f;
        for (Light& light : scene.lights) light.emission *= 2.0f;
        const Image twice = render(scene, changed(matrixSettings(), change), 2);
        for (size_t i = 0; i < once.texels.size(); ++i) ASSERT_EQ(twice.texels[i], 2.0f * once.texels[i]) << i;
    }
}

TEST_F(EquivalenceOnce, LocalAndGlobalMakeBoth) {
    const Scene scene = cornellBox();
    for (const Change change : {unchanged, compensated, pathTraced, forward}) {
        RenderSettings settings = changed(matrixSettings(), change);
        const Image both = render(scene, settings);
        settings.lighting = Lighting::Local;
        const Image local = render(scene, settings);
        settings.lighting = Lighting::Global;
        const Image global = render(scene, settings);
        for (size_t i = 0; i < both.texels.size(); ++i)
            ASSERT_NEAR(both.texels[i], local.texels[i] + global.texels[i], 2e-6f * (1.0f + both.texels[i])) << i;
    }
}

class SameToRounding : public GpuTest, public ::testing::WithParamInterface<Pair> {};

INSTANTIATE_TEST_SUITE_P(Equivalence, SameToRounding,
                         ::testing::Values(Pair{"Forward", forward, unchanged},
                                           // One large shader: what is left out may change how the rest is rounded.
                                           Pair{"NothingLeftOutForward", forward,
                                                [](RenderSettings& s) {
                                                    forward(s);
                                                    s.plan = false;
                                                }},
                                           Pair{"ForwardPrepass",
                                                [](RenderSettings& s) { s.technique = Technique::ForwardPrepass; },
                                                unchanged},
                                           Pair{"ForwardCompensated",
                                                [](RenderSettings& s) {
                                                    forward(s);
                                                    compensated(s);
                                                },
                                                compensated}),
                         nameOf);

/// The G-buffer keeps albedos in steps of 2^-21 and rounds normals; a compensation ray at the end of its reach may fall
/// on either side of it: hence one value in a hundred, and for the others 1e-5 as in forward_deferred_test.cpp.
TEST_P(SameToRounding, ButForRaysAtTheEndOfTheirReach) {
    for (const Scene& scene : {cornellBox(), everyKindOfLight()}) {
        const Image left = render(scene, changed(matrixSettings(), GetParam().left));
        const Image right = render(scene, changed(matrixSettings(), GetParam().right));
        const double mean = meanOf(right);
        size_t further = 0;
        for (size_t i = 0; i < right.texels.size(); ++i)
            further += std::abs(double{left.texels[i]} - double{right.texels[i]}) >
                               1e-5 * (double{right.texels[i]} + 0.1 * mean)
                           ? 1
                           : 0;
        EXPECT_LE(100 * further, right.texels.size());
        EXPECT_GT(mean, 0.0);
    }
}

class SameInExpectation : public GpuTest, public ::testing::WithParamInterface<Pair> {};

// Bounded, so that samples of all sides have a finite variance.
INSTANTIATE_TEST_SUITE_P(Equivalence, SameInExpectation,
                         ::testing::Values(Pair{"PathTracer", compensated, pathTraced},
                                           Pair{"Unclamped", compensated, unchanged},
                                           Pair{"Forward", compensated,
                                                [](RenderSettings& s) {
                                                    compensated(s);
                                                    forward(s);
                                                }},
                                           Pair{"CompensatingEverything", compensated,
                                                [](RenderSettings& s) {
                                                    compensated(s);
                                                    s.clampBound = 1e-6f;
                                                }},
                                           Pair{"NoRoulette", compensated,
                                                [](RenderSettings& s) {
                                                    compensated(s);
                                                    s.russianRoulette = false;
                                                    s.pathCount = 30;  // the list takes all their vertices
                                                }},
                                           Pair{"NoRoulettePathTraced", pathTraced,
                                                [](RenderSettings& s) {
                                                    pathTraced(s);
                                                    s.russianRoulette = false;
                                                }},
                                           Pair{"FewVpls", compensated,
                                                [](RenderSettings& s) {
                                                    compensated(s);
                                                    s.vplCount = 37;
                                                }},
                                           Pair{"FewVplsOfManyPaths", compensated,
                                                [](RenderSettings& s) {
                                                    compensated(s);
                                                    s.vplCount = 37;
                                                    s.pathCount = 2000;
                                                }},
                                           Pair{"SeveralBatchesOfPaths", compensated,
                                                [](RenderSettings& s) {
                                                    compensated(s);
                                                    s.pathCount = 20000;
                                                }}),
                         nameOf);

std::vector<double> meansOfSeeds(Renderer& renderer, RenderSettings settings) {
    const uint32_t frames = settings.technique == Technique::PathTracer ? 16 : 8;
    std::vector<double> means;
    for (settings.seed = 0; settings.seed < 16; ++settings.seed) {
        renderer.restart(settings);
        for (uint32_t i = 0; i < frames; ++i) renderer.renderFrame();
        means.push_back(meanOf(renderer.radiance()));
    }
    return means;
}

struct MeanAndError {
    double mean;
    double error;
};

MeanAndError meanAndError(const std::vector<double>& samples) {
    const auto count = static_cast<double>(samples.size());
    const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) / count;
    double squares = 0.0;
    for (const double sample : samples) squares += (sample - mean) * (sample - mean);
    return {mean, std::sqrt(squares / (count * (count - 1.0)))};
}

/// Five bounces with roulette from the start leave what those without have; the scene is unevenBox(), of which a bounce
/// more or less is 5 % and more.
TEST_P(SameInExpectation, OverSeeds) {
    RenderSettings settings = matrixSettings(8);
    settings.bounceCount = 5;
    const Scene scene = unevenBox();
    Renderer renderer(device(), scene, settings, pipelines());
    const MeanAndError left = meanAndError(meansOfSeeds(renderer, changed(settings, GetParam().left)));
    const MeanAndError right = meanAndError(meansOfSeeds(renderer, changed(settings, GetParam().right)));
    const double error = std::hypot(left.error, right.error);
    EXPECT_LT(error, 0.01 * right.mean) << "the samples scatter too much to say anything";
    EXPECT_LT(std::abs(left.mean - right.mean), 5.0 * error)
        << left.mean << " +- " << left.error << ", " << right.mean << " +- " << right.error;
}

TEST_F(EquivalenceOnce, RasterAndRaysSeeTheSameSurfaces) {
    constexpr uint32_t kSize = 64;
    for (const Scene& scene : {cornellBox(), everyKindOfLight()}) {
        Renderer renderer(device(), scene, matrixSettings(kSize), pipelines());
        const GBufferImage gbuffer = captureGBuffer(renderer, scene);
        RayCaster caster(device(), scene, buildBvh(scene));
        const RaySet rays = primaryRays(scene.cameras[0], kSize, kSize);  // in Morton order
        caster.load(rays);
        caster.trace(RayKind::ClosestHit);
        const std::vector<shared::RayHit> hits = caster.hits();
        size_t others = 0;
        for (size_t i = 0; i < hits.size(); ++i) {
            size_t pixel = 0;
            for (size_t bit = 0; bit < 6; ++bit)
                pixel |= (i >> (2 * bit) & 1u) << bit | (i >> (2 * bit + 1) & 1u) * kSize << bit;
            const GBufferTexel& texel = gbuffer.texels[pixel];
            const bool isHit = hits[i].triangle != shared::kNoHit;
            if (isHit != texel.isSurface || (isHit && hits[i].triangle != texel.triangle)) {
                ++others;
            } else if (isHit) {
                const glm::vec3 position = rays[i].origin + hits[i].t * rays[i].direction;
                ASSERT_LT(glm::length(position - texel.position), 1e-5f) << pixel;
            }
        }
        // Rasterisation places corners on a grid of 1/256 pixel: along edges another triangle may be seen. An edge of
        // the picture crosses 64 pixels and a hundred of them are in view.
        EXPECT_LE(others, 64u * 100u / 256u);
    }
}

}  // namespace
}  // namespace manylight::test
