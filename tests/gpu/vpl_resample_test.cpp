// Gathering from some of the VPLs, with rays for some of those: the mean is that of all pairs and all rays.
#include "engine/core/error.h"
#include "tests/gpu/test_scenes.h"
#include "tests/gpu/z_test.h"
#include "tests/support/significance.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

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

/// A room with a lamp at either end and a board between, round which about half of the light comes.
Scene dividedRoom() {
    Scene scene = closedBox(glm::vec3(0.7f));
    scene.lights.push_back(pointLight({0.3f, 0.35f, 0.1f}, glm::vec3(1.0f)));
    scene.lights.push_back(pointLight({-0.35f, -0.2f, -0.3f}, glm::vec3(1.0f)));
    addQuad(scene, {-0.02f, -0.5f, -0.5f}, {0.04f, 0, 0.75f}, {0, 0.8f, 0}, 0);
    return finished(std::move(scene));
}

/// Sum over quarters of pictures of z^2, z being the sum of what the draws put pixels off by, over its own standard
/// error. Pixels draw independently of each other, from one list of VPLs: z is as of a normal variable if each VPL is
/// drawn as often as its weight says, and grows with the number of pixels if one is not, as it lights many pixels of a
/// quarter, or none.
struct SquaredErrors {
    double sum = 0.0;
    double count = 0.0;

    void add(const Image& drawn, const Image& whole, double scale) {
        for (uint32_t y = 0; y < whole.height; y += whole.height / 2)
            for (uint32_t x = 0; x < whole.width; x += whole.width / 2) addQuarter(drawn, whole, scale, {x, y});
    }
    double pValue() const { return chiSquarePValue(sum, count); }

  private:
    void addQuarter(const Image& drawn, const Image& whole, double scale, glm::uvec2 first) {
        double offBy = 0.0;
        double squares = 0.0;
        for (uint32_t y = first.y; y < first.y + whole.height / 2; ++y)
            for (uint32_t x = first.x; x < first.x + whole.width / 2; ++x) {
                const double truth = double{whole.at(x, y, 0)};
                const double difference = double{drawn.at(x, y, 0)} - scale * truth;
                if (std::abs(difference) < 1e-5 * truth) continue;  // rounding
                offBy += difference;
                squares += difference * difference;
            }
        if (squares == 0.0) return;
        sum += offBy * offBy / squares;
        count += 1.0;
    }
};

struct Draws {
    uint32_t vpls;
    uint32_t rays;
    uint32_t interleave;
};

// Against a ray for each of the very same VPLs, of which half or so are in shadow. Over lists the light that a wrong
// draw takes from one VPL and gives to another is made good, as any place of the list may hold any VPL; from one list
// it is not.
TEST_F(VplResample, EachVplOfAListIsDrawnAsOftenAsItsWeightSays) {
    const Scene scene = dividedRoom();
    RenderSettings settings = gatherSettings(64, 48);
    Renderer renderer(device(), scene, settings);
    const auto pictureWith = [&](uint32_t rays) {
        settings.shadowRays = rays;
        renderer.restart(settings);
        renderer.renderFrame();
        return renderer.radiance();
    };
    for (const Draws draws : {Draws{17, 1, 1}, Draws{64, 4, 1}, Draws{150, 4, 1}, Draws{70, 1, 2}}) {
        SCOPED_TRACE(fmt::format("{} VPLs, {} rays, interleave {}", draws.vpls, draws.rays, draws.interleave));
        settings.vplCount = draws.vpls;
        settings.interleave = draws.interleave;
        SquaredErrors errors;
        SquaredErrors ofDimmed;
        for (settings.seed = 0; settings.seed < 16; ++settings.seed) {
            const Image whole = pictureWith(0);
            const Image drawn = pictureWith(draws.rays);
            errors.add(drawn, whole, 1.0);
            ofDimmed.add(drawn, whole, 0.9);
        }
        EXPECT_GT(errors.count, 40.0);
        EXPECT_GT(errors.pValue(), 0.001) << errors.sum << " for " << errors.count;
        EXPECT_LT(ofDimmed.pValue(), 1e-6) << "the draws scatter too much to say anything";
    }
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
