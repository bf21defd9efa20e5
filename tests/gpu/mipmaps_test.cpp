// Textures that are seen from afar are seen as their mean, at once; from near they are what they are.
#include "engine/passes/pack_materials.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <glm/gtc/constants.hpp>

namespace manylight::test {
namespace {

constexpr Technique kTechniques[] = {Technique::Deferred, Technique::Forward, Technique::PathTracer};

/// A floor in black and white squares of so many texels, lit from straight above, so that white has the radiance 1.
Scene checkeredFloor(uint32_t texels, float repeats, uint32_t square = 1) {
    Scene scene = floorFromAbove(1.0f);
    Texture texture;
    texture.width = texture.height = texels;
    texture.isMipmapped = true;
    for (uint32_t i = 0; i < texels * texels; ++i) {
        const uint8_t value = (i % texels / square + i / texels / square) % 2 == 0 ? 255 : 0;
        texture.rgba.insert(texture.rgba.end(), {value, value, value, 255});
    }
    scene.textures.push_back(texture);
    scene.materials[0].albedoTexture = {.texture = 0, .uvSet = 0, .uvMatrix = glm::mat2(repeats), .uvOffset = {}};
    scene.lights.push_back(directionalLight({0, -1, 0}, glm::vec3(glm::pi<float>())));
    return finished(std::move(scene));
}

RenderSettings lampOnly(Technique technique) {
    RenderSettings settings = plainSettings(16, 12);
    settings.technique = technique;
    settings.castShadows = true;
    settings.lighting = Lighting::Local;
    return settings;
}

class Mipmaps : public GpuTest, public ::testing::WithParamInterface<Technique> {};
INSTANTIATE_TEST_SUITE_P(Techniques, Mipmaps, ::testing::ValuesIn(kTechniques), [](const auto& test) {
    std::string word = name(test.param);
    std::erase(word, '-');
    return word;
});

TEST_P(Mipmaps, AFineCheckerboardIsItsMeanInOneFrame) {
    Scene scene = checkeredFloor(64, 7.3f);  // 30 texels a pixel
    const auto furthest = [&](const Image& picture) {
        float distance = 0.0f;
        for (uint32_t i = 0; i < picture.width * picture.height; ++i)
            for (uint32_t c = 0; c < 3; ++c)
                distance = std::max(distance, std::abs(picture.texels[i * picture.channels + c] - 0.5f));
        return distance;
    };
    EXPECT_LT(furthest(render(scene, lampOnly(GetParam()))), 0.005f);  // half the light is the code 187.5 of 255
    if (GetParam() == Technique::Forward) return;  // slow to compile, and the next says nothing new of it
    scene.textures[0].isMipmapped = false;
    EXPECT_GT(furthest(render(scene, lampOnly(GetParam()))), 0.2f);
}

TEST_P(Mipmaps, FromNearAndWithoutThemPicturesAreTheSame) {
    Scene scene = checkeredFloor(4, 1.0f);
    const Image mipmapped = render(scene, lampOnly(GetParam()));
    scene.textures[0].isMipmapped = false;
    RenderSettings settings = lampOnly(GetParam());
    EXPECT_TRUE(sameBits(render(scene, settings), mipmapped));
    if (GetParam() == Technique::Forward) return;
    settings.plan = false;
    EXPECT_TRUE(sameBits(render(scene, settings), mipmapped));
}

class MipmapsOverFrames : public GpuTest {};

TEST_F(MipmapsOverFrames, TheMeanIsThatOfTheTextureItself) {
    Scene scene = checkeredFloor(32, 1.3f, 8);  // squares of three pixels, 2.6 texels each
    for (const Technique technique : {Technique::Deferred, Technique::PathTracer}) {
        SCOPED_TRACE(name(technique));
        RenderSettings settings = lampOnly(technique);
        settings.jitter = true;
        scene.textures[0].isMipmapped = false;
        const Image texture = render(scene, settings, 64);
        scene.textures[0].isMipmapped = true;
        const auto meanDistance = [&](uint32_t frames) {
            const Image picture = render(scene, settings, frames);
            double sum = 0.0;
            for (size_t i = 0; i < picture.texels.size(); ++i) sum += std::abs(picture.texels[i] - texture.texels[i]);
            return sum / static_cast<double>(picture.texels.size());
        };
        EXPECT_GT(meanDistance(1), 0.05);
        EXPECT_LT(meanDistance(64), 0.01);
    }
}

TEST(MipmapsPacked, OnlyWhereTheyAreAskedForAndOnce) {
    Scene scene = checkeredFloor(4, 1.0f);
    scene.materials[0].opacityTexture = scene.materials[0].albedoTexture;
    const PackedMaterials packed = packMaterials(scene, planScene(scene));
    EXPECT_EQ(packed.texels.size(), 4u * (16 + 4 + 1));
    EXPECT_EQ(packed.textureInfos[packed.materials[0].albedoTexture].levelCount, 3u);
    EXPECT_EQ(packed.textureInfos[packed.materials[0].opacityTexture].levelCount, 1u);
    scene.textures[0].isMipmapped = false;
    EXPECT_EQ(packMaterials(scene, planScene(scene)).texels.size(), 4u * 16);
}

}  // namespace
}  // namespace manylight::test
