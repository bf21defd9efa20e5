#include "engine/scene/derived_texture.h"

#include <gtest/gtest.h>
#include <glm/glm.hpp>

#include <cmath>

namespace manylight::testing {
namespace {

EncodedImage greyImage(uint32_t width, uint32_t height, auto&& valueAt) {
    EncodedImage image{width, height, {}};
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const auto value = static_cast<uint8_t>(valueAt(x, y));
            image.rgba.insert(image.rgba.end(), {value, value, value, 255});
        }
    return image;
}

glm::dvec3 normalAt(const EncodedImage& image, uint32_t x, uint32_t y) {
    const uint8_t* const texel = image.rgba.data() + 4 * (size_t{y} * image.width + x);
    return glm::dvec3(texel[0], texel[1], texel[2]) / 127.5 - 1.0;
}

TEST(DerivedTexture, NormalsOfASlopeLeanDownhill) {
    // A plane that rises by 10 grey levels per texel to the right and by 20 per row, towards the picture's bottom.
    const EncodedImage heights = greyImage(6, 6, [](uint32_t x, uint32_t y) { return 10 * x + 20 * y; });
    const EncodedImage normals = normalsOfHeights(heights, 'l', 25.5, {});
    const glm::dvec3 expected = glm::normalize(glm::dvec3(-1.0, 2.0, 1.0));  // green is up in the picture
    for (uint32_t y = 1; y < 5; ++y)
        for (uint32_t x = 1; x < 5; ++x)
            EXPECT_LT(glm::length(normalAt(normals, x, y) - expected), 0.01) << x << " " << y;
}

TEST(DerivedTexture, HeightsGoOnAsTheTextureWraps) {
    const EncodedImage heights = greyImage(4, 4, [](uint32_t x, uint32_t) { return 50 * x; });
    Texture sampling;
    const auto redOfFirst = [&] { return normalAt(normalsOfHeights(heights, 'r', 5.1, sampling), 0, 2).x; };
    EXPECT_GT(redOfFirst(), 0.5);  // from 50 on the right up to 150 on the left
    for (const TextureWrap wrap : {TextureWrap::ClampToEdge, TextureWrap::MirroredRepeat}) {
        sampling.wrapU = wrap;
        EXPECT_LT(redOfFirst(), -0.3);  // from 50 on the right down to 0
    }
}

TEST(DerivedTexture, FlatHeightsStandUpright) {
    const EncodedImage heights = greyImage(3, 2, [](uint32_t, uint32_t) { return 77; });
    const EncodedImage normals = normalsOfHeights(heights, 'l', 1000.0, {});
    for (uint32_t x = 0; x < 3; ++x) EXPECT_GT(normalAt(normals, x, 1).z, 0.999);
}

TEST(DerivedTexture, TellsNormalMapsFromHeights) {
    EXPECT_TRUE(looksLikeNormals({2, 1, {128, 128, 255, 255, 100, 150, 230, 255}}));
    EXPECT_FALSE(looksLikeNormals({1, 1, {128, 128, 128, 255}}));
    EXPECT_FALSE(looksLikeNormals({1, 1, {255, 255, 255, 255}}));
    EXPECT_FALSE(looksLikeNormals({1, 1, {20, 40, 250, 255}}));
}

TEST(DerivedTexture, CutoutsAreNearlyAllOrNothing) {
    const auto withAlphas = [](uint8_t edge, size_t edges, size_t holes) {
        EncodedImage image{100, 1, std::vector<uint8_t>(400, 255)};
        for (size_t i = 0; i < edges + holes; ++i) image.rgba[4 * i + 3] = i < edges ? edge : 0;
        return image;
    };
    EXPECT_TRUE(isCutout(withAlphas(128, 10, 50)));
    EXPECT_FALSE(isCutout(withAlphas(128, 11, 50)));
    EXPECT_TRUE(isCutout(withAlphas(250, 40, 50)));
    EXPECT_FALSE(isCutout(withAlphas(128, 0, 0)));
    EXPECT_TRUE(hasAlpha(withAlphas(254, 1, 0)));
    EXPECT_FALSE(hasAlpha(withAlphas(128, 0, 0)));
}

}  // namespace
}  // namespace manylight::testing
