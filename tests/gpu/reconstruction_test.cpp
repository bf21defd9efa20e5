// The filter after an interleaved gather: it brings back what all VPLs give, keeps the mean, and fades.
#include "engine/techniques/reconstruction.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <cmath>

namespace manylight::test {
namespace {

class Reconstruction : public GpuTest {};

RenderSettings interleaved(uint32_t interleave, Filter filter) {
    RenderSettings settings = plainSettings(96, 72);
    settings.lighting = Lighting::Global;
    settings.clamp = ClampMode::Bound;
    settings.castShadows = true;
    settings.russianRoulette = true;
    settings.bounceCount = 5;
    settings.vplCount = 256;
    settings.interleave = interleave;
    settings.filter = filter;
    return settings;
}

double meanSquaredDifference(const Image& a, const Image& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.texels.size(); ++i) sum += std::pow(double{a.texels[i]} - double{b.texels[i]}, 2);
    return sum / static_cast<double>(a.texels.size());
}

TEST_F(Reconstruction, BringsBackWhatAllVplsGive) {
    const Scene scene = cornellBox();
    const Image all = render(scene, interleaved(1, Filter::Off), 1);
    const Image some = render(scene, interleaved(4, Filter::Off), 1);
    const Image filtered = render(scene, interleaved(4, Filter::Atrous), 1);
    EXPECT_LT(meanSquaredDifference(filtered, all), 0.05 * meanSquaredDifference(some, all));
    EXPECT_NEAR(meanOf(filtered), meanOf(all), 0.02 * meanOf(all));
}

TEST_F(Reconstruction, AFourthOfThePixelsSpeaksForTheirNeighbours) {
    const Scene scene = cornellBox();
    double ofAll = 0.0;
    double ofCoarse = 0.0;
    for (uint32_t seed = 0; seed < 4; ++seed) {
        RenderSettings settings = interleaved(1, Filter::Off);
        settings.seed = seed;
        const Image all = render(scene, settings, 1);
        settings.interleave = 4;
        const Image some = render(scene, settings, 1);
        settings.filter = Filter::Atrous;
        settings.gatherStep = 2;
        const Image coarse = render(scene, settings, 1);
        EXPECT_LT(meanSquaredDifference(coarse, all), 0.1 * meanSquaredDifference(some, all));
        ofAll += meanOf(all);
        ofCoarse += meanOf(coarse);
    }
    EXPECT_NEAR(ofCoarse, ofAll, 0.02 * ofAll);
}

/// Without a filter, by so many frames that what the compensation leaves to chance is small beside a filter's error.
Image unfilteredTruth(const Scene& scene) {
    RenderSettings settings = interleaved(1, Filter::Off);
    settings.clamp = ClampMode::Compensate;
    settings.vplCount = 512;
    settings.shadowRays = 4;
    return render(scene, settings, 96);
}

TEST_F(Reconstruction, SmoothsWhatCompensationGivesBack) {
    const Scene scene = cornellBox();
    const Image truth = unfilteredTruth(scene);
    RenderSettings settings = interleaved(1, Filter::Off);
    settings.clamp = ClampMode::Compensate;
    const Image noisy = render(scene, settings, 1);
    settings.interleave = 4;
    settings.filter = Filter::Atrous;
    const Image filtered = render(scene, settings, 1);
    EXPECT_LT(meanSquaredDifference(filtered, truth), 0.5 * meanSquaredDifference(noisy, truth));
    EXPECT_NEAR(meanOf(filtered), meanOf(noisy), 0.02 * meanOf(noisy));  // of the same VPLs
}

// Not light is filtered here, but how much of it arrives.
TEST_F(Reconstruction, ByVisibilityBringsBackWhatAllVplsGive) {
    const Scene scene = cornellBox();
    const Image all = render(scene, interleaved(1, Filter::Off), 1);
    RenderSettings settings = interleaved(4, Filter::Off);
    settings.shadowRays = 4;
    const Image some = render(scene, settings, 1);
    settings.filter = Filter::Ratio;
    const Image ratio = render(scene, settings, 1);
    EXPECT_LT(meanSquaredDifference(ratio, all), 0.1 * meanSquaredDifference(some, all));
    EXPECT_NEAR(meanOf(ratio), meanOf(all), 0.03 * meanOf(all));  // shadows are blurred: brighter here, darker there
    settings.gatherStep = 2;
    EXPECT_NEAR(meanOf(render(scene, settings, 1)), meanOf(all),
                0.05 * meanOf(all));  // and half of the period's pixels
}

// Of few rays likewise; and textures stay sharp, as light is filtered without what surfaces make of it.
TEST_F(Reconstruction, KeepsTexturesSharp) {
    const Scene scene = patternedRoom();
    RenderSettings settings = interleaved(2, Filter::Off);
    const Image some = render(scene, settings, 1);
    settings.filter = Filter::Atrous;
    const Image filtered = render(scene, settings, 1);
    settings.interleave = 1;
    settings.filter = Filter::Off;
    const Image all = render(scene, settings, 1);
    EXPECT_LT(meanSquaredDifference(filtered, all), 0.3 * meanSquaredDifference(some, all));
}

RenderSettings directLight(uint32_t samples, Filter filter) {
    RenderSettings settings = interleaved(4, filter);
    settings.lighting = Lighting::Local;
    settings.lightSampleCount = samples;
    return settings;
}

TEST_F(Reconstruction, SmoothsLightOfAreaLights) {
    const Scene scene = cornellBox();
    const Image truth = render(scene, directLight(64, Filter::Off), 16);
    for (const auto& [samples, share] : {std::pair{1u, 0.2}, std::pair{4u, 0.5}}) {
        const Image noisy = render(scene, directLight(samples, Filter::Off), 1);
        const Image filtered = render(scene, directLight(samples, Filter::Atrous), 1);
        EXPECT_LT(meanSquaredDifference(filtered, truth), share * meanSquaredDifference(noisy, truth)) << samples;
        EXPECT_NEAR(meanOf(filtered), meanOf(truth), 0.01 * meanOf(truth));
    }
}

TEST_F(Reconstruction, LightOfAreaLightsIsTheSameInOneDispatchOrSeveral) {
    // More samples than a dispatch takes on.
    const Scene scene = cornellBox();
    const Image truth = render(scene, directLight(64, Filter::Off), 16);
    const Image noisy = render(scene, directLight(300, Filter::Off), 1);
    const Image filtered = render(scene, directLight(300, Filter::Atrous), 1);
    EXPECT_NEAR(meanOf(filtered), meanOf(noisy), 0.001 * meanOf(noisy));
    // So many leave next to no noise, and the blur of penumbrae is about as large.
    EXPECT_LT(meanSquaredDifference(filtered, truth), 2.0 * meanSquaredDifference(noisy, truth));
}

TEST_F(Reconstruction, LeavesLightOfPointLightsAsItIs) {
    Scene scene = sphereInBox();
    std::erase_if(scene.lights, [](const Light& light) { return light.type != LightType::Point; });
    for (Material& material : scene.materials) material.emittedRadiance = glm::vec3(0.0f);
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(0.5f)));
    scene = finished(std::move(scene));
    EXPECT_TRUE(
        sameBits(render(scene, directLight(4, Filter::Atrous), 1), render(scene, directLight(4, Filter::Off), 1)));
}

TEST_F(Reconstruction, ErrorFallsAsFramesComeIn) {
    const Scene scene = cornellBox();
    const Image truth = unfilteredTruth(scene);
    RenderSettings settings = interleaved(4, Filter::Atrous);
    settings.clamp = ClampMode::Compensate;
    const double first = meanSquaredDifference(render(scene, settings, 1), truth);
    // Radii fall as i^(-1/6), that of the box from the fifth frame on, bias with their square, and its mean over N = 48
    // frames is 3/2 N^(-1/3) = 0.41 of the first's; its square is 0.17. What is left to chance falls as 1 / N.
    const double later = meanSquaredDifference(render(scene, settings, 48), truth);
    EXPECT_LT(later, 0.25 * first) << first << " and " << later;  // the noise of what is taken for true is in both
}

TEST(ReconstructionSchedule, OfAreaLightsVanishesToo) {
    float before = areaLightSchedule(0).levels.front().deviations;
    for (uint32_t frame = 1; frame < 64; ++frame) {
        const ReconstructionSchedule schedule = areaLightSchedule(frame);
        ASSERT_EQ(schedule.levels.size(), 1u) << frame;
        ASSERT_LE(schedule.levels.front().deviations, before) << frame;
        before = schedule.levels.front().deviations;
    }
    EXPECT_FALSE(areaLightSchedule(64).filters());
}

TEST(ReconstructionSchedule, TapsAreNoFartherApartForMoreSubsets) {
    const auto spacings = [](uint32_t interleave) {
        std::vector<uint32_t> all;
        for (const ReconstructionStep& level : reconstructionSchedule(interleave, 1, 0).levels)
            all.push_back(level.spacing);
        return all;
    };
    EXPECT_EQ(spacings(1), (std::vector<uint32_t>{1, 2, 4}));
    EXPECT_EQ(spacings(4), (std::vector<uint32_t>{2, 4, 8}));
    EXPECT_EQ(spacings(8), (std::vector<uint32_t>{4, 8}));
    EXPECT_EQ(spacings(32), (std::vector<uint32_t>{16}));  // the box has left nothing nearer
}

TEST(ReconstructionSchedule, FourFramesHaveAWholeBoxAndThoseOnAGridAllOfTheFilter) {
    const auto deviations = [](uint32_t step) { return reconstructionSchedule(4, step, 3).levels.front().deviations; };
    EXPECT_LT(deviations(1), deviations(2));
    for (uint32_t frame = 0; frame < 4; ++frame) {
        EXPECT_EQ(reconstructionSchedule(4, 1, frame).blockWidth, 4.0f) << frame;
        EXPECT_EQ(reconstructionSchedule(4, 2, frame).blockWidth, 4.0f) << frame;
        EXPECT_EQ(reconstructionSchedule(4, 2, frame).gatherStep, 2u) << frame;
    }
    EXPECT_LT(reconstructionSchedule(4, 2, 4).blockWidth, 4.0f);
    EXPECT_EQ(reconstructionSchedule(4, 2, 4).gatherStep, 1u);
}

TEST(ReconstructionSchedule, VanishesInTheEnd) {
    const ReconstructionSchedule first = reconstructionSchedule(4, 2, 0);
    EXPECT_EQ(first.blockWidth, 4.0f);
    ASSERT_FALSE(first.levels.empty());
    float width = first.blockWidth;
    for (uint32_t frame = 1; frame < 1u << 20; frame *= 4) {
        const ReconstructionSchedule next = reconstructionSchedule(4, 2, frame);
        EXPECT_LE(next.blockWidth, width);
        EXPECT_LE(next.levels.size(), first.levels.size());
        width = next.blockWidth;
    }
    const ReconstructionSchedule last = reconstructionSchedule(4, 2, 1u << 23);
    EXPECT_EQ(last.blockWidth, 1.0f);
    EXPECT_TRUE(last.levels.empty());
    EXPECT_EQ(first.gatherStep, 2u);
    EXPECT_EQ(last.gatherStep, 1u);
    EXPECT_EQ(effectiveGatherStep(6, 4), 3u);
    EXPECT_EQ(effectiveGatherStep(1, 2), 1u);
}

}  // namespace
}  // namespace manylight::test
