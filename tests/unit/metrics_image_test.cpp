#include "engine/metrics/false_colour.h"
#include "engine/metrics/image_region.h"

#include "engine/core/error.h"
#include "tests/unit/flip_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace manylight::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ImageRegion, IsReadFromFourNumbers) {
    const Region region = regionFrom("3,0,17,4");
    EXPECT_EQ(region.x, 3u);
    EXPECT_EQ(region.y, 0u);
    EXPECT_EQ(region.width, 17u);
    EXPECT_EQ(region.height, 4u);
    for (const char* text : {"", "1", "1,2,3", "1,2,3,", "1,2,3,4,", "1,2,3,4,5", "1,2,-3,4", "1, 2,3,4", "a,b,c,d",
                             "1,2,0,4", "1,2,3,0", "1,2,3,99999999999", "1;2;3;4", ",,,"})
        EXPECT_THROW(regionFrom(text), Error) << text;
}

TEST(ImageRegion, CutsOutWhatItSays) {
    const Image picture = pictureOf(7, 5, [](uint32_t x, uint32_t y, uint32_t c) { return 100 * x + 10 * y + c; });
    const Image part = cut(picture, {2, 1, 5, 4}, "p");
    ASSERT_EQ(part.width, 5u);
    ASSERT_EQ(part.height, 4u);
    for (uint32_t y = 0; y < 4; ++y)
        for (uint32_t x = 0; x < 5; ++x)
            for (uint32_t c = 0; c < 3; ++c) EXPECT_EQ(part.at(x, y, c), picture.at(x + 2, y + 1, c));
}

TEST(ImageRegion, OutsideThePictureIsAnErrorThatNamesBoth) {
    const Image picture(7, 5, 3);
    const uint32_t large = std::numeric_limits<uint32_t>::max();
    for (const Region region : {Region{3, 1, 5, 4}, Region{0, 0, 7, 6}, Region{7, 0, 1, 1}, Region{large, 0, large, 1}})
        EXPECT_THROW(cut(picture, region, "p"), Error);
    try {
        cut(picture, {3, 1, 5, 4}, "a.exr");
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("a.exr"), HasSubstr("3,1,5,4"), HasSubstr("7 x 5")));
    }
}

TEST(Mask, CountsPixelsWithAnyChannelThatIsNotZero) {
    Image picture(2, 2, 3);
    picture.at(1, 0, 2) = 1e-30f;
    picture.at(0, 1, 0) = -2.0f;
    EXPECT_EQ(maskFrom(picture).uses, (std::vector<uint8_t>{0, 1, 1, 0}));
}

TEST(FalseColour, ScalesGoFromEndToEndAndStayInRange) {
    EXPECT_LT(magma(0.0f).g, 0.01f);
    EXPECT_GT(magma(1.0f).g, 0.98f);
    EXPECT_EQ(magma(-1.0f), magma(0.0f));
    EXPECT_EQ(magma(2.0f), magma(1.0f));
    EXPECT_GT(blueGreyRed(-1.0f).b, blueGreyRed(-1.0f).r);
    EXPECT_GT(blueGreyRed(1.0f).r, blueGreyRed(1.0f).b);
    EXPECT_NEAR(blueGreyRed(0.0f).r, blueGreyRed(0.0f).b, 0.01f);
    float lightness = -1.0f;
    for (int i = 0; i <= 100; ++i) {
        const glm::vec3 colour = magma(static_cast<float>(i) / 100.0f);
        const float next = 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b;
        EXPECT_GT(next, lightness) << i;
        lightness = next;
    }
}

TEST(FalseColour, MagmaIsMatplotlibs) {
    // matplotlib 3.11, magma at index 40 and 200 of 0 to 255.
    const glm::vec3 dark = magma(40.0f / 255.0f);
    const glm::vec3 light = magma(200.0f / 255.0f);
    EXPECT_NEAR(dark.r, 0.159018f, 0.03f);
    EXPECT_NEAR(dark.b, 0.352688f, 0.03f);
    EXPECT_NEAR(light.r, 0.992440f, 0.03f);
    EXPECT_NEAR(light.g, 0.587502f, 0.03f);
}

}  // namespace
}  // namespace manylight::test
