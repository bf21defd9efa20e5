#include "engine/metrics/error.h"
#include "engine/metrics/error_split.h"

#include "engine/core/error.h"
#include "engine/metrics/luminance.h"
#include "tests/unit/flip_pictures.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace manylight::test {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Image plain(uint32_t width, uint32_t height, double value) {
    return pictureOf(width, height, [value](uint32_t, uint32_t, uint32_t) { return value; });
}

TEST(ImageError, OfEqualPicturesIsZero) {
    const Image picture = flipPictures("noise").reference;
    const ErrorReport error = compareImages(picture, picture);
    EXPECT_EQ(error.pixels, 64u * 48u);
    EXPECT_EQ(error.rmse, 0.0);
    EXPECT_EQ(error.relativeMse, 0.0);
    EXPECT_EQ(error.smape, 0.0);
    EXPECT_EQ(error.worstShare, 0.0);
    EXPECT_EQ(error.rmseWithoutWorst, 0.0);
    EXPECT_EQ(error.nonFinite, 0u);
    for (size_t c = 0; c < 3; ++c) EXPECT_EQ(meanRatio(error, c), 1.0);
}

TEST(ImageError, OfPlainPicturesHasAClosedForm) {
    // Over the mean luminance 2, r is 1 and v is 1.5.
    const ErrorReport error = compareImages(plain(5, 4, 3.0), plain(5, 4, 2.0));
    EXPECT_NEAR(error.meanLuminanceReference, 2.0, 1e-12);
    EXPECT_NEAR(error.rmse, 1.0, 1e-12);
    EXPECT_NEAR(*error.relativeMse, 0.25 / 1.01, 1e-12);
    EXPECT_NEAR(*error.smape, 0.5 / 2.51, 1e-12);
    EXPECT_NEAR(*meanRatio(error, 1), 1.5, 1e-12);
    EXPECT_EQ(error.worstPixels, 1u);
    EXPECT_NEAR(error.worstShare, 1.0 / 20.0, 1e-12);
    EXPECT_NEAR(error.rmseWithoutWorst, 1.0, 1e-12);
}

TEST(ImageError, MeansAreThoseOfEachChannel) {
    const Image test = pictureOf(3, 1, [](uint32_t x, uint32_t, uint32_t c) { return c == 0 ? x : 2.0 * c; });
    const Image reference = pictureOf(3, 1, [](uint32_t, uint32_t, uint32_t c) { return c == 2 ? 0.0 : 4.0; });
    const ErrorReport error = compareImages(test, reference);
    EXPECT_EQ(error.meanTest, (std::array<double, 3>{1.0, 2.0, 4.0}));
    EXPECT_EQ(error.meanReference, (std::array<double, 3>{4.0, 4.0, 0.0}));
    EXPECT_EQ(meanRatio(error, 0), 0.25);
    EXPECT_EQ(meanRatio(error, 2), std::nullopt);
    EXPECT_NEAR(error.meanLuminanceReference, 4.0 * (0.2126 + 0.7152), 1e-12);
}

TEST(ImageError, TheWorstPixelsTakeTheirShareOfTheSquaredError) {
    // 2000 pixels: the worst 0.1 % are two. One is off by 30, one by 20, a third by 10, all others by 1.
    const Image reference = plain(50, 40, 1.0);
    Image test = plain(50, 40, 2.0);
    for (uint32_t c = 0; c < 3; ++c) {
        test.at(7, 3, c) = 31.0f;
        test.at(49, 39, c) = -19.0f;
        test.at(0, 0, c) = 11.0f;
    }
    const ErrorReport error = compareImages(test, reference);
    EXPECT_EQ(error.worstPixels, 2u);
    const double others = 100.0 + 1997.0;
    EXPECT_NEAR(error.worstShare, 1300.0 / (1300.0 + others), 1e-12);
    EXPECT_NEAR(error.rmse, std::sqrt((1300.0 + others) / 2000.0), 1e-12);
    EXPECT_NEAR(error.rmseWithoutWorst, std::sqrt(others / 1998.0), 1e-12);
}

TEST(ImageError, RelativeMeasuresHaveNoUnit) {
    const PicturePair pair = flipPictures("noise");
    const ErrorReport expected = compareImages(pair.test, pair.reference);
    for (const int exponent : {-100, -1, 7, 100}) {
        const PicturePair scaled = flipPictures("noise", std::ldexp(1.0, exponent));
        const ErrorReport error = compareImages(scaled.test, scaled.reference);
        EXPECT_EQ(error.relativeMse, expected.relativeMse) << exponent;
        EXPECT_EQ(error.smape, expected.smape) << exponent;
        EXPECT_EQ(error.worstShare, expected.worstShare) << exponent;
        EXPECT_EQ(error.rmse, std::ldexp(expected.rmse, exponent)) << exponent;
    }
}

TEST(ImageError, IsTheSameBothWaysWhereItsFormulaIs) {
    const PicturePair pair = flipPictures("gradient");
    const ErrorReport there = compareImages(pair.test, pair.reference);
    const ErrorReport back = compareImages(pair.reference, pair.test);
    EXPECT_EQ(there.rmse, back.rmse);
    EXPECT_EQ(there.worstShare, back.worstShare);
    EXPECT_NE(there.relativeMse, back.relativeMse);

    // Over equal mean luminances, SMAPE is symmetric too: mirrored pictures have one.
    const Image left = pictureOf(16, 1, [](uint32_t x, uint32_t, uint32_t) { return x; });
    const Image right = pictureOf(16, 1, [](uint32_t x, uint32_t, uint32_t) { return 15.0 - x; });
    EXPECT_EQ(compareImages(left, right).smape, compareImages(right, left).smape);
}

TEST(ImageError, IsUndefinedOverABlackReferenceAndOnlyThere) {
    const ErrorReport error = compareImages(plain(4, 4, 1.0), plain(4, 4, 0.0));
    EXPECT_EQ(error.relativeMse, std::nullopt);
    EXPECT_EQ(error.smape, std::nullopt);
    EXPECT_EQ(error.rmse, 1.0);
    EXPECT_TRUE(compareImages(plain(4, 4, 1.0), plain(4, 4, 1e-40)).relativeMse);
}

TEST(ImageError, PixelsThatAreNotFiniteAreLeftOutAndCounted) {
    PicturePair pair = flipPictures("noise");
    PicturePair cleaned = flipPictures("noise");
    const auto agree = [&](uint32_t x, uint32_t y) {
        for (uint32_t c = 0; c < 3; ++c) cleaned.test.at(x, y, c) = cleaned.reference.at(x, y, c);
    };
    pair.test.at(1, 2, 0) = kNaN;
    pair.test.at(5, 6, 2) = -kInfinity;
    pair.reference.at(5, 6, 1) = kInfinity;
    pair.reference.at(63, 47, 0) = std::bit_cast<float>(0xffffffffu);
    agree(1, 2), agree(5, 6), agree(63, 47);

    const ErrorReport error = compareImages(pair.test, pair.reference);
    EXPECT_EQ(error.nonFinite, 3u);
    EXPECT_EQ(error.nonFiniteTest, 2u);
    EXPECT_EQ(error.nonFiniteReference, 2u);
    EXPECT_EQ(error.pixels, 64u * 48u - 3u);
    const double n = 64 * 48;
    EXPECT_NEAR(error.rmse * std::sqrt((n - 3.0) / n), compareImages(cleaned.test, cleaned.reference).rmse, 1e-12);
    EXPECT_EQ(compareImages(pair.test, pair.test).nonFinite, 2u);
}

TEST(ImageError, OfNoPixelAtAllIsAnError) {
    const Image picture = plain(3, 2, 1.0);
    const Mask nothing{3, 2, std::vector<uint8_t>(6, 0)};
    EXPECT_THROW(compareImages(picture, picture, &nothing), Error);
    EXPECT_THROW(compareImages(plain(3, 2, kNaN), picture), Error);
}

TEST(ImageError, AMaskIsAsGoodAsCuttingOut) {
    const PicturePair pair = flipPictures("steps");
    const Region region{11, 7, 40, 33};
    Mask mask{97, 61, std::vector<uint8_t>(97 * 61, 0)};
    for (uint32_t y = 0; y < region.height; ++y)
        for (uint32_t x = 0; x < region.width; ++x) mask.uses[(region.y + y) * 97 + region.x + x] = 1;
    const ErrorReport masked = compareImages(pair.test, pair.reference, &mask);
    const ErrorReport cutOut = compareImages(cut(pair.test, region, "a"), cut(pair.reference, region, "b"));
    EXPECT_EQ(masked.pixels, 40u * 33u);
    EXPECT_EQ(masked.maskedOut, 97u * 61u - 40u * 33u);
    EXPECT_GT(masked.rmse, 0.0);
    EXPECT_EQ(masked.rmse, cutOut.rmse);
    EXPECT_EQ(masked.relativeMse, cutOut.relativeMse);
    EXPECT_EQ(masked.smape, cutOut.smape);
    EXPECT_EQ(masked.worstShare, cutOut.worstShare);
    EXPECT_EQ(masked.meanTest, cutOut.meanTest);
}

/// K pictures, each value 1 + bias + noise uniform in [-w, w].
std::vector<Image> runsOf(size_t count, double bias, double halfWidth) {
    std::vector<Image> runs;
    for (uint32_t k = 0; k < count; ++k)
        runs.push_back(pictureOf(64, 64, [&](uint32_t x, uint32_t y, uint32_t c) {
            return 1.0 + bias + halfWidth * (2.0 * hashedUnit(x, y, c, k) - 1.0);
        }));
    return runs;
}

TEST(ErrorSplit, ToldApartAreBiasAndVariance) {
    const double halfWidth = 0.3;
    const double variance = halfWidth * halfWidth / 3.0;
    for (const double bias : {0.0, 0.05, -0.2}) {
        const std::vector<Image> runs = runsOf(8, bias, halfWidth);
        const ErrorSplit split = splitError(runs, plain(64, 64, 1.0));
        // 12288 values, each a mean of 8: one standard error of the bias² is below 5e-4 here, that of the variance
        // 1e-4.
        EXPECT_NEAR(split.biasSquared, bias * bias, 1.5e-3) << bias;
        EXPECT_NEAR(split.variance, variance, 1e-3) << bias;
        double sum = 0.0;
        for (const Image& run : runs) sum += std::pow(compareImages(run, plain(64, 64, 1.0)).rmse, 2.0);
        EXPECT_NEAR(split.meanSquaredError, sum / 8.0, 1e-9);
        EXPECT_DOUBLE_EQ(split.meanSquaredError, split.biasSquared + split.variance);
    }
}

TEST(ErrorSplit, EqualRunsHaveNoVariance) {
    const std::vector<Image> runs(3, plain(4, 4, 1.5));
    const ErrorSplit split = splitError(runs, plain(4, 4, 1.0));
    EXPECT_EQ(split.variance, 0.0);
    EXPECT_EQ(split.biasSquared, 0.25);
}

TEST(ErrorSplit, APixelThatIsNotFiniteInOneRunIsLeftOutOfAll) {
    std::vector<Image> runs(4, plain(4, 4, 1.5));
    runs[2].at(3, 3, 1) = kNaN;
    runs[3].at(3, 3, 0) = kInfinity;
    runs[1].at(0, 1, 0) = kInfinity;
    const ErrorSplit split = splitError(runs, plain(4, 4, 1.0));
    EXPECT_EQ(split.nonFinite, 2u);
    EXPECT_EQ(split.pixels, 14u);
    EXPECT_EQ(split.biasSquared, 0.25);
}

TEST(Luminance, WeightsSumToOne) {
    const float white[] = {1.0f, 1.0f, 1.0f};
    EXPECT_NEAR(luminanceOf(white), 1.0, 1e-12);
}

}  // namespace
}  // namespace manylight::test
