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
    const Image all = render(scene, interleaved(1, Filter::Off), 1);
    const Image some = render(scene, interleaved(4, Filter::Off), 1);
    RenderSettings settings = interleaved(4, Filter::Atrous);
    settings.gatherStep = 2;
    const Image coarse = render(scene, settings, 1);
    EXPECT_LT(meanSquaredDifference(coarse, all), 0.1 * meanSquaredDifference(some, all));
    EXPECT_NEAR(meanOf(coarse), meanOf(all), 0.02 * meanOf(all));
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

TEST_F(Reconstruction, ErrorFallsAsFramesComeIn) {
    const Scene scene = cornellBox();
    RenderSettings settings = interleaved(1, Filter::Off);
    settings.vplCount = 2048;
    settings.clamp = ClampMode::Compensate;
    const Image truth = render(scene, settings, 8);
    settings.vplCount = 256;
    settings.interleave = 4;
    settings.filter = Filter::Atrous;
    const double first = meanSquaredDifference(render(scene, settings, 1), truth);
    const double later = meanSquaredDifference(render(scene, settings, 12), truth);
    EXPECT_LT(later, first / 4.0) << first << " and " << later;
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
}

}  // namespace
}  // namespace manylight::test
