#include "engine/scene/mipmaps.h"

#include "engine/scene/scene_plan.h"

#include <gtest/gtest.h>

namespace manylight::testing {
namespace {

using Bytes = std::vector<uint8_t>;

Texture textureOf(uint32_t width, uint32_t height, Bytes rgba) {
    Texture texture;
    texture.width = width;
    texture.height = height;
    texture.rgba = std::move(rgba);
    return texture;
}

TEST(Mipmaps, ColoursAreAveragedInLinearLight) {
    const Texture texture = textureOf(2, 1, {0, 255, 0, 255, 255, 255, 0, 0});
    // Half the light is the code 187.5 of 255.
    EXPECT_EQ(reducedTexels(texture, Averaging::Colours), (Bytes{188, 255, 0, 128}));
    EXPECT_EQ(reducedTexels(texture, Averaging::Numbers), (Bytes{128, 255, 0, 128}));
}

TEST(Mipmaps, WhatIsNotThereLendsNoColour) {
    const Texture leaf = textureOf(2, 1, {0, 100, 0, 255, 255, 255, 255, 0});
    const Bytes reduced = reducedTexels(leaf, Averaging::ColoursByOpacity);
    EXPECT_LE(reduced[0], 4);
    EXPECT_NEAR(reduced[1], 100, 1);
    const Texture nothing = textureOf(2, 1, {10, 20, 30, 0, 10, 20, 30, 0});
    const Bytes unseen = reducedTexels(nothing, Averaging::ColoursByOpacity);
    EXPECT_EQ(Bytes(unseen.begin(), unseen.begin() + 3), (Bytes{10, 20, 30}));
}

TEST(Mipmaps, EveryTexelOfAnOddSizeCountsAlike) {
    Bytes column;
    for (const uint8_t value : Bytes{0, 60, 255, 0, 0}) column.insert(column.end(), {value, value, value, 255});
    // 5 texels become 2 of 2.5 each, then 1.
    const Bytes reduced = reducedTexels(textureOf(1, 5, column), Averaging::Numbers);
    ASSERT_EQ(reduced.size(), 12u);
    EXPECT_EQ(reduced[0], 75);  // (0 + 60 + 255 / 2) / 2.5
    EXPECT_EQ(reduced[4], 51);  // (255 / 2) / 2.5
    EXPECT_EQ(reduced[8], 63);  // (0 + 60 + 255 + 0 + 0) / 5
    EXPECT_EQ(levelsOf(1, 5), 3u);
    EXPECT_EQ(texelsOfReduced(1, 5), 3u);
    const Bytes wide(size_t{4} * 37 * 20, 77);
    const Bytes all = reducedTexels(textureOf(37, 20, wide), Averaging::Numbers);
    EXPECT_EQ(all.size(), 4 * texelsOfReduced(37, 20));
    EXPECT_EQ(all, Bytes(all.size(), 77));
}

TEST(Mipmaps, PlannedWhereASamplerAsksForThem) {
    Scene scene;
    scene.vertices.resize(3);
    scene.triangles = {{{0, 1, 2}, 0}};
    scene.materials.resize(1);
    scene.materials[0].albedoTexture.texture = 0;
    scene.textures = {textureOf(4, 4, Bytes(64, 0))};
    EXPECT_FALSE(planScene(scene).mipmapped);
    scene.textures[0].isMipmapped = true;
    EXPECT_TRUE(planScene(scene).mipmapped);
    EXPECT_NE(explain(planScene(scene)).find("up to 20 bytes"), std::string::npos);  // four texels and one
    scene.materials[0].albedoTexture.texture = kNoTexture;
    EXPECT_FALSE(planScene(scene).mipmapped);
}

}  // namespace
}  // namespace manylight::testing
