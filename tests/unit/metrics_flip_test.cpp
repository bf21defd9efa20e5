#include "engine/metrics/flip.h"

#include "engine/core/error.h"
#include "engine/metrics/flip_colour.h"
#include "engine/metrics/flip_filters.h"
#include "tests/unit/flip_figures.h"
#include "tests/unit/flip_pictures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace manylight::test {
namespace {

using namespace perception;

FlipResult flipOf(const FlipFigures& figures, const PicturePair& pair) {
    const FlipOptions options{figures.pixelsPerDegree, nullptr};
    return figures.isHdr ? hdrFlip(pair.test, pair.reference, options).value()
                         : ldrFlip(pair.test, pair.reference, options);
}

TEST(Flip, AgreesWithTheAuthorsEvaluator) {
    for (const FlipFigures& figures : kFlipFigures) {
        SCOPED_TRACE(fmt::format("{} {} {}", figures.picture, figures.isHdr, figures.pixelsPerDegree));
        const FlipResult flip = flipOf(figures, flipPictures(figures.picture, figures.isHdr ? 1.0 : 0.25));
        // Both compute in float but in different orders: sums of about twenty products, rounded by 6e-8 each. A
        // constant that is off by 2 % shows as 1e-4 or more.
        EXPECT_NEAR(flip.mean, figures.mean, 5e-6);
        for (size_t i = 0; i < std::size(kFlipPlaces); ++i)
            EXPECT_NEAR(flip.map.at(kFlipPlaces[i][0], kFlipPlaces[i][1], 0), figures.values[i], 1e-5) << i;
    }
}

TEST(Flip, ExposuresAreThoseOfTheAuthorsEvaluator) {
    for (const FlipFigures& figures : kFlipFigures) {
        if (!figures.isHdr) continue;
        const PicturePair pair = flipPictures(figures.picture);
        const std::vector<uint8_t> all(size_t{pair.reference.width} * pair.reference.height, 1);
        const FlipExposures exposures = flipExposures(pair.reference, all).value();
        EXPECT_NEAR(exposures.start, figures.startExposure, 2e-6) << figures.picture;
        EXPECT_NEAR(exposures.stop, figures.stopExposure, 2e-6) << figures.picture;
        EXPECT_EQ(exposures.count, figures.exposureCount) << figures.picture;
        EXPECT_DOUBLE_EQ(exposures.at(0), exposures.start);
        EXPECT_DOUBLE_EQ(exposures.at(exposures.count - 1), exposures.stop);
    }
}

TEST(FlipColour, CubeRootsAreExactToFloatPrecision) {
    for (float value = 0.001f; value < 2.0f; value *= 1.01f)
        EXPECT_NEAR(cubeRoot(value) / std::cbrt(double{value}), 1.0, 4e-7) << value;
}

TEST(FlipColour, WhiteGreyAndPrimariesAreWhereCielabHasThem) {
    const auto lab = [](float r, float g, float b) { return huntLab(colourSpace().xyzFromRgb * Triple{r, g, b}); };
    const HuntLab white = lab(1, 1, 1);
    EXPECT_NEAR(white.lightness, 100.0, 1e-3);
    EXPECT_NEAR(white.a, 0.0, 1e-3);
    EXPECT_NEAR(white.b, 0.0, 1e-3);
    EXPECT_NEAR(lab(0.18418652f, 0.18418652f, 0.18418652f).lightness, 50.0, 1e-3);  // ((50 + 16) / 116)³
    EXPECT_NEAR(lab(0, 0, 0).lightness, 0.0, 1e-5);
    // CIELAB of sRGB's blue under D65 is (32.30, 79.19, -107.86); Hunt's adjustment takes a and b times L / 100.
    const HuntLab blue = lab(0, 0, 1);
    EXPECT_NEAR(blue.lightness, 32.30, 0.02);
    EXPECT_NEAR(blue.a, 0.3230 * 79.19, 0.05);
    EXPECT_NEAR(blue.b, 0.3230 * -107.86, 0.05);
    EXPECT_NEAR(colourDistance(white, blue), (white.lightness - blue.lightness) + std::hypot(blue.a, blue.b), 1e-3);
}

TEST(FlipFilters, KeepAPlainPictureAndFindNoFeatureInIt) {
    const FlipFilters filters = flipFilters(kDefaultPixelsPerDegree);
    Plane plain(31, 17);
    for (float& value : plain.values) value = 0.5f;
    const auto both = [&](const HalfFilter& rows, const HalfFilter& columns) {
        return filterColumns(filterRows(plain, rows), columns).values[100];
    };
    EXPECT_NEAR(both(filters.luminance, filters.luminance), 0.5, 1e-6);
    EXPECT_NEAR(both(filters.redGreen, filters.redGreen), 0.5, 1e-6);
    EXPECT_NEAR(both(filters.gaussian, filters.gaussian), 0.5, 1e-6);
    const HalfFilter(&blueYellow)[2] = filters.blueYellow;
    EXPECT_NEAR(both(blueYellow[0], blueYellow[0]) + both(blueYellow[1], blueYellow[1]), 0.5, 1e-6);
    EXPECT_EQ(both(filters.edge, filters.gaussian), 0.0f);
    EXPECT_NEAR(both(filters.point, filters.gaussian), 0.0, 1e-6);
}

TEST(FlipFilters, AreTheSameAlongRowsAndColumns) {
    const FlipFilters filters = flipFilters(40.0);
    Plane plane(23, 19);
    Plane turned(19, 23);
    for (size_t y = 0; y < 19; ++y)
        for (size_t x = 0; x < 23; ++x)
            plane.row(y)[x] = turned.row(x)[y] =
                static_cast<float>(hashedUnit(static_cast<uint32_t>(x), static_cast<uint32_t>(y), 0, 9));
    for (const HalfFilter* filter : {&filters.luminance, &filters.edge, &filters.point}) {
        const Plane rows = filterRows(plane, *filter);
        const Plane columns = filterColumns(turned, *filter);
        for (size_t y = 0; y < 19; ++y)
            for (size_t x = 0; x < 23; ++x) EXPECT_EQ(rows.row(y)[x], columns.row(x)[y]);
    }
}

TEST(Flip, EqualPicturesHaveNone) {
    for (const char* name : {"noise", "gradient", "steps"}) {
        const Image reference = flipPictures(name).reference;
        EXPECT_EQ(hdrFlip(reference, reference)->mean, 0.0);
        EXPECT_EQ(ldrFlip(reference, reference).mean, 0.0);
    }
}

TEST(Flip, OfDisplayedPicturesIsSymmetric) {
    const PicturePair pair = flipPictures("noise", 0.25);
    EXPECT_EQ(ldrFlip(pair.test, pair.reference).mean, ldrFlip(pair.reference, pair.test).mean);
}

TEST(Flip, BlackAgainstWhiteAndGreenAgainstBlueAreNearlyOne) {
    const auto plain = [](float r, float g, float b) {
        return pictureOf(40, 40, [&](uint32_t, uint32_t, uint32_t c) { return c == 0 ? r : c == 1 ? g : b; });
    };
    // The largest difference that there is maps to 1; black and white are a little nearer to each other.
    EXPECT_NEAR(ldrFlip(plain(0, 1, 0), plain(0, 0, 1)).mean, 1.0, 1e-4);
    EXPECT_GT(ldrFlip(plain(0, 0, 0), plain(1, 1, 1)).mean, 0.95);
    EXPECT_LT(ldrFlip(plain(0.5f, 0.5f, 0.5f), plain(0.51f, 0.5f, 0.5f)).mean, 0.05);
}

TEST(Flip, OfRadianceDoesNotDependOnItsUnit) {
    for (const char* name : {"noise", "gradient"}) {
        const PicturePair pair = flipPictures(name);
        const double expected = hdrFlip(pair.test, pair.reference)->mean;
        for (const int exponent : {-100, -30, -3, 1, 60, 100}) {
            const PicturePair scaled = flipPictures(name, std::ldexp(1.0, exponent));
            // Exposures are floats: at 100 stops they are rounded to 4e-6.
            EXPECT_NEAR(hdrFlip(scaled.test, scaled.reference)->mean, expected, 2e-5) << name << exponent;
        }
    }
}

TEST(Flip, ABlackReferenceHasNoExposures) {
    const Image black(8, 8, 3);
    EXPECT_FALSE(flipExposures(black, std::vector<uint8_t>(64, 1)));
    EXPECT_FALSE(hdrFlip(flipPictures("noise").reference, flipPictures("noise", 0.0).reference));
    EXPECT_EQ(ldrFlip(black, black).mean, 0.0);
}

TEST(Flip, SinglePixelsAndLargestValuesAreFine) {
    const Image pixel = pictureOf(1, 1, [](uint32_t, uint32_t, uint32_t) { return 3.0; });
    EXPECT_EQ(hdrFlip(pixel, pixel)->mean, 0.0);
    Image huge = flipPictures("noise").test;
    huge.texels[100] = std::numeric_limits<float>::max();
    huge.texels[200] = -std::numeric_limits<float>::max();
    const FlipResult flip = hdrFlip(huge, flipPictures("noise").reference).value();
    EXPECT_TRUE(flip.mean > 0.1 && flip.mean < 1.0) << flip.mean;
}

TEST(Flip, PixelsThatAreNotFiniteAreLeftOutAndCounted) {
    PicturePair pair = flipPictures("noise");
    const FlipResult before = hdrFlip(pair.test, pair.reference).value();
    pair.test.at(10, 11, 1) = std::numeric_limits<float>::quiet_NaN();
    pair.reference.at(40, 30, 2) = std::numeric_limits<float>::infinity();
    const FlipResult flip = hdrFlip(pair.test, pair.reference).value();
    EXPECT_EQ(flip.nonFinite, 2u);
    EXPECT_EQ(flip.pixels, 64u * 48u - 2u);
    EXPECT_TRUE(std::isnan(flip.map.at(10, 11, 0)));
    EXPECT_TRUE(std::isnan(flip.map.at(40, 30, 0)));
    // Far from both nothing changes; near them neighbours see a black pixel in both pictures.
    EXPECT_NEAR(flip.map.at(63, 0, 0), before.map.at(63, 0, 0), 1e-3);
    EXPECT_NEAR(flip.mean, before.mean, 0.02);
}

TEST(Flip, APreparedReferenceGivesTheSameBits) {
    PicturePair pair = flipPictures("noise");
    pair.reference.at(12, 40, 0) = std::numeric_limits<float>::infinity();
    Mask mask{64, 48, std::vector<uint8_t>(64 * 48, 1)};
    mask.uses[100] = 0;
    const FlipOptions options{50.0, &mask};
    const HdrFlipReference reference(pair.reference, options);
    Image broken = pair.test;
    broken.at(30, 20, 2) = std::numeric_limits<float>::quiet_NaN();
    for (const Image* test : {&pair.test, &broken}) {
        const FlipResult prepared = reference.compare(*test).value();
        const FlipResult direct = hdrFlip(*test, pair.reference, options).value();
        EXPECT_EQ(prepared.mean, direct.mean);
        EXPECT_EQ(prepared.nonFinite, direct.nonFinite);
        EXPECT_EQ(prepared.exposures.start, direct.exposures.start);
        for (size_t i = 0; i < direct.map.texels.size(); ++i)
            EXPECT_EQ(std::bit_cast<uint32_t>(prepared.map.texels[i]), std::bit_cast<uint32_t>(direct.map.texels[i]));
    }
    EXPECT_FALSE(HdrFlipReference(Image(8, 8, 3)).compare(Image(8, 8, 3)));
}

TEST(Flip, AMaskChoosesFromTheMapOfTheWholePicture) {
    const PicturePair pair = flipPictures("noise", 0.25);
    const FlipResult whole = ldrFlip(pair.test, pair.reference);
    Mask mask{64, 48, std::vector<uint8_t>(64 * 48)};
    mask.uses[47 * 64 + 63] = 1;
    mask.uses[9 * 64 + 40] = 1;
    const FlipResult masked = ldrFlip(pair.test, pair.reference, {kDefaultPixelsPerDegree, &mask});
    EXPECT_EQ(masked.pixels, 2u);
    EXPECT_DOUBLE_EQ(masked.mean, (double{whole.map.at(63, 47, 0)} + double{whole.map.at(40, 9, 0)}) / 2.0);

    mask.uses.assign(mask.uses.size(), 0);
    EXPECT_THROW(ldrFlip(pair.test, pair.reference, {kDefaultPixelsPerDegree, &mask}), Error);
}

}  // namespace
}  // namespace manylight::test
