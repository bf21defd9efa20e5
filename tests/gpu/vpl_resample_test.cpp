// Gathering from some of the VPLs, with rays for some of those: the mean is that of all pairs and all rays.
#include "engine/core/error.h"
#include "tests/gpu/test_scenes.h"
#include "tests/gpu/z_test.h"

#include <gmock/gmock.h>

namespace manylight::test {
namespace {

RenderSettings gatherSettings(uint32_t width, uint32_t height) {
    RenderSettings settings = plainSettings(width, height);
    settings.vplCount = 300;
    settings.bounceCount = 4;
    settings.russianRoulette = true;
    settings.castShadows = true;
    settings.lighting = Lighting::Global;
    return settings;
}

using VplResample = GpuTest;

TEST_F(VplResample, ACycleOfInterleavedPicturesIsTheWholeGather) {
    const Scene scene = sphereInBox();
    for (const bool shadows : {false, true})
        for (const uint32_t n : {2u, 3u}) {
            SCOPED_TRACE(n);
            RenderSettings settings = gatherSettings(23, 17);
            settings.castShadows = shadows;
            const Image whole = render(scene, settings);
            settings.interleave = n;
            Renderer renderer(device(), scene, settings, pipelines());
            std::vector<double> sum(whole.texels.size());
            double largestStep = 0.0;
            for (settings.interleavePhase = 0; settings.interleavePhase < n * n; ++settings.interleavePhase) {
                renderer.restart(settings);
                renderer.renderFrame();
                const Image part = renderer.radiance();
                for (size_t i = 0; i < sum.size(); ++i) {
                    sum[i] += double{part.texels[i]} / (n * n);
                    largestStep = std::max(largestStep, std::abs(double{part.texels[i]} - double{whole.texels[i]}));
                }
            }
            EXPECT_GT(largestStep, 0.1 * meanOf(whole)) << "the subsets are all the same";
            for (size_t i = 0; i < sum.size(); ++i)
                ASSERT_NEAR(sum[i], double{whole.texels[i]}, 2e-6 * meanOf(whole) + 2e-6 * sum[i]) << i;
        }
}

// In a convex grey room every ray arrives, and every draw gives total / rays: nothing is left to chance.
TEST_F(VplResample, WhereNothingIsInShadowAnyNumberOfRaysGivesTheWholeSum) {
    Scene scene = closedBox(glm::vec3(0.6f));
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.05f}, glm::vec3(1.0f)));
    scene = finished(std::move(scene));
    RenderSettings settings = gatherSettings(24, 18);
    settings.vplCount = 1000;
    settings.castShadows = false;
    const Image whole = render(scene, settings);
    settings.castShadows = true;
    for (const uint32_t rays : {1u, 3u, 16u}) {
        settings.shadowRays = rays;
        const Image image = render(scene, settings);
        for (size_t i = 0; i < image.texels.size(); ++i)
            ASSERT_NEAR(image.texels[i], whole.texels[i], 1e-5f * whole.texels[i]) << rays << " rays, " << i;
    }
}

struct Case {
    const char* name;
    Scene (*scene)();
};

class ResampledMeans : public GpuTest, public ::testing::WithParamInterface<Case> {};

INSTANTIATE_TEST_SUITE_P(Scenes, ResampledMeans,
                         ::testing::Values(Case{"TwoRooms", twoRooms}, Case{"GlossyRoom", glossyRoom}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(ResampledMeans, AreThoseOfThePathTracer) {
    const Scene scene = GetParam().scene();
    RenderSettings settings = gatherSettings(12, 9);
    settings.vplCount = 600;
    settings.bounceCount = 6;
    settings.clamp = ClampMode::Compensate;
    settings.clampBound = 4.0f;
    RenderSettings truthful = settings;
    truthful.technique = Technique::PathTracer;
    truthful.clamp = ClampMode::Off;
    const PictureSamples truth = samplePictures(scene, truthful, {.first = 1000, .count = 24, .frames = 48});
    settings.interleave = 2;
    settings.shadowRays = 2;
    const PictureSamples resampled = samplePictures(scene, settings, {.count = 32, .frames = 12});
    expectSameMeans(resampled, truth, 0.008);
    EXPECT_TRUE(toldApart(scaled(resampled, 1.05), truth));
}

TEST_F(VplResample, IsRefusedWhereItIsNot) {
    RenderSettings settings = gatherSettings(8, 8);
    settings.technique = Technique::Forward;
    settings.shadowRays = 4;
    try {
        render(sphereInBox(), settings);
        FAIL() << "nothing was said";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("expected --technique deferred"));
    }
}

}  // namespace
}  // namespace manylight::test
