#include "tests/unit/import_test_support.h"

#include <cmath>

namespace manylight::testing {
namespace {

/// A scene of one triangle whose material the test writes.
class ObjTextures : public SceneFiles {
  protected:
    Scene withMaterial(std::string_view statements) const {
        write("a.mtl", fmt::format("newmtl m\n{}\n", statements));
        return import("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.75\nusemtl m\nf 1/1 2/1 3/1\n");
    }
};

/// Where a corner with these coordinates in the OBJ file (v up) is looked up, v up again.
glm::vec2 lookedUpAt(const TextureUse& use, glm::vec2 uv) {
    const glm::vec2 found = use.uvMatrix * glm::vec2(uv.x, 1.0f - uv.y) + use.uvOffset;
    return {found.x, 1.0f - found.y};
}

TEST_F(ObjTextures, TexturesAreFoundBesideTheLibrary) {
    write("maps/red green.tga", redGreenTga());
    write("maps/a.mtl", "newmtl a\nmap_Kd .\\red green.tga\nnewmtl b\nmap_Kd missing.png\nKd 0.5 0.5 0.5\n");
    const Scene scene = import("a.obj",
                               "mtllib nowhere.mtl maps/a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nusemtl a\n"
                               "f 1/1 2/1 3/1\nusemtl b\nf 1 2 3\n");
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.textures[0].width, 2u);
    EXPECT_EQ(scene.textures[0].rgba[0], 255);
    EXPECT_EQ(scene.textures[0].rgba[5], 255);
    EXPECT_EQ(scene.materials[0].albedoTexture.texture, 0);
    EXPECT_EQ(scene.materials[1].albedoTexture.texture, kNoTexture);
    EXPECT_EQ(scene.materials[1].albedo, glm::vec3(0.5f));
    EXPECT_EQ(scene.warnings.count("textures left out: image not readable"), 1u);
    EXPECT_EQ(scene.warnings.count("material libraries missing"), 1u);
}

TEST_F(ObjTextures, OffsetsScalesAndClamping) {
    write("rg.tga", redGreenTga());
    const Scene scene = withMaterial("map_Kd -o 0.5 0.25 -s 2 4 -clamp on -blendu off rg.tga");
    const TextureUse& use = scene.materials[0].albedoTexture;
    EXPECT_EQ(lookedUpAt(use, {0, 0}), glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(lookedUpAt(use, {1, 0}), glm::vec2(2.5f, 0.25f));
    EXPECT_EQ(lookedUpAt(use, {0, 1}), glm::vec2(0.5f, 4.25f));
    EXPECT_EQ(scene.textures[0].wrapU, TextureWrap::ClampToEdge);
    EXPECT_EQ(scene.textures[0].wrapV, TextureWrap::ClampToEdge);
    const Scene partly = withMaterial("map_Kd -s 2 1 1 -o 0.5 rg.tga");
    EXPECT_EQ(lookedUpAt(partly.materials[0].albedoTexture, {1, 1}), glm::vec2(2.5f, 1.0f));
    EXPECT_EQ(partly.textures[0].wrapU, TextureWrap::Repeat);
}

TEST_F(ObjTextures, OptionsAfterAndInsideNames) {
    write("a -s b.tga", redGreenTga());
    EXPECT_TRUE(withMaterial("map_Kd a -s b.tga").materials[0].albedoTexture.exists());
    const Scene behind = withMaterial("map_Kd a -s b.tga -o 0.5 0");
    EXPECT_EQ(behind.materials[0].albedoTexture.texture, 0);
    EXPECT_EQ(behind.materials[0].albedoTexture.uvOffset.x, 0.5f);
    const Warnings warnings = withMaterial("map_Kd -t 1 1 1 -mm 0 2 -s x -imfchan z -o nan a -s b.tga").warnings;
    EXPECT_EQ(warnings.count("texture options ignored"), 3u);
    EXPECT_EQ(warnings.count("texture options ignored: no finite number"), 2u);
}

TEST_F(ObjTextures, CoverageFromLuminance) {
    write("binary.tga", rgbaTga(2, 1, {255, 255, 255, 255, 0, 0, 0, 255}));
    write("soft.tga", rgbaTga(2, 1, {255, 255, 255, 255, 128, 128, 128, 255}));
    const Scene cutout = withMaterial("map_d binary.tga");
    EXPECT_EQ(cutout.materials[0].alphaMode, AlphaMode::Mask);
    const Texture& texture = cutout.textures.at(static_cast<size_t>(cutout.materials[0].opacityTexture.texture));
    EXPECT_EQ(texture.rgba[3], 255);
    EXPECT_EQ(texture.rgba[7], 0);
    EXPECT_EQ(withMaterial("map_d binary.tga\nd 0.5").materials[0].alphaMode, AlphaMode::Blend);
    EXPECT_EQ(withMaterial("map_d binary.tga\nd 0.5").materials[0].opacity, 0.5f);
    const Scene soft = withMaterial("map_d soft.tga");
    EXPECT_EQ(soft.materials[0].alphaMode, AlphaMode::Blend);
    EXPECT_EQ(soft.textures[0].rgba[7], 128);
    EXPECT_EQ(withMaterial("map_d gone.tga").materials[0].alphaMode, AlphaMode::Opaque);
    EXPECT_EQ(withMaterial("map_d gone.tga").warnings.count("textures left out: image not readable"), 1u);
}

TEST_F(ObjTextures, CoverageFromAlphaSharesTheImage) {
    write("leaf.tga", rgbaTga(2, 1, {255, 0, 0, 255, 255, 255, 255, 0}));
    const Scene scene = withMaterial("map_Kd leaf.tga\nmap_d leaf.tga");
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.materials[0].opacityTexture.texture, 0);
    EXPECT_EQ(scene.textures[0].rgba[7], 0);
    EXPECT_EQ(scene.materials[0].alphaMode, AlphaMode::Mask);
    // The picture that is drawn does not take its colours from the one that is cut out.
    write("plain.tga", rgbaTga(2, 1, {255, 0, 0, 255, 0, 0, 0, 255}));
    const Scene both = withMaterial("map_Kd plain.tga\nmap_d plain.tga");
    EXPECT_EQ(both.textures.size(), 2u);
    EXPECT_EQ(both.textures[0].rgba[3], 255);
    EXPECT_EQ(both.textures[1].rgba[3], 54);  // 0.2126 * 255
    EXPECT_EQ(withMaterial("map_d -imfchan r plain.tga").textures[0].rgba[3], 255);
}

TEST_F(ObjTextures, NormalMapsAndHeights) {
    write("normals.tga", rgbaTga(1, 1, {128, 128, 255, 255}));
    write("heights.tga", rgbaTga(3, 1, {0, 0, 0, 255, 128, 128, 128, 255, 255, 255, 255, 255}));
    const Scene mapped = withMaterial("norm -bm 0.5 normals.tga\nbump heights.tga");
    EXPECT_EQ(mapped.materials[0].normalScale, 0.5f);
    ASSERT_EQ(mapped.textures.size(), 1u);
    EXPECT_EQ(mapped.textures[0].rgba[2], 255);

    const Scene bumpy = withMaterial("map_Bump -bm 2 -clamp on heights.tga");
    EXPECT_EQ(bumpy.materials[0].normalScale, 1.0f);
    ASSERT_EQ(bumpy.textures.size(), 1u);
    // Rises towards the right by half of white in a texel; white is 2 * 1 % of three texels high.
    const double slope = -0.5 * 2 * 0.01 * 3;
    EXPECT_NEAR(bumpy.textures[0].rgba[4], 127.5 * (1 + slope / std::hypot(slope, 1.0)), 0.6);
    EXPECT_EQ(bumpy.textures[0].rgba[5], 128);

    const Scene taken = withMaterial("bump -bm 0.25 normals.tga");
    EXPECT_EQ(taken.materials[0].normalScale, 0.25f);
    EXPECT_EQ(taken.textures[0].rgba[2], 255);
    EXPECT_EQ(taken.warnings.count("bump maps that hold normals taken as normal maps"), 1u);
    EXPECT_FALSE(withMaterial("bump -bm 0 heights.tga").materials[0].normalTexture.exists());
    EXPECT_FALSE(withMaterial("bump gone.tga").materials[0].normalTexture.exists());
}

}  // namespace
}  // namespace manylight::testing
