// Environment maps in sidecars: EXR and Radiance files, and what is wrong with them.
#include "engine/image/image_io.h"
#include "tests/unit/import_test_support.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace manylight::testing {
namespace {

using ::testing::HasSubstr;

class EnvironmentFile : public SceneFiles {
  protected:
    EnvironmentFile() { write("room.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n"); }

    void writeMap(const std::string& name, const Image& image) const {
        writeExr(folder_ / name, {{"", {"R", "G", "B"}, image}}, {});
    }
    static std::string sidecar(const std::string& light) {
        return R"({"scene": "room.obj", "lights": [{"type": "environment", )" + light + "}]}";
    }
    Scene importMap(const std::string& light) const { return import("room.json", sidecar(light)); }
    std::string errorWith(const std::string& light) const { return errorOf("room.json", sidecar(light)); }
};

Image gradient(uint32_t width, uint32_t height) {
    Image image(width, height, 3);
    for (size_t i = 0; i < image.texels.size(); ++i) image.texels[i] = 0.25f * static_cast<float>(i);
    return image;
}

/// Texels of mantissas and a shared exponent, not compressed.
std::string radianceFile(const std::string& rgbe, const std::string& size) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + rgbe;
}

TEST_F(EnvironmentFile, ExrIsReadScaledAndTurned) {
    writeMap("sky.exr", gradient(4, 2));
    const Scene scene = importMap(R"("image": "sky.exr", "scale": [1, 2, 4], "rotation_deg": -90, "name": "sky")");
    ASSERT_TRUE(scene.environment);
    EXPECT_EQ(scene.environment->name, "sky");
    EXPECT_EQ(scene.environment->turn, 0.75f);
    EXPECT_EQ(scene.environment->radiance.width, 4u);
    EXPECT_EQ(scene.environment->radiance.height, 2u);
    EXPECT_EQ(scene.environment->radiance.at(1, 0, 0), 0.75f);
    EXPECT_EQ(scene.environment->radiance.at(1, 0, 1), 2.0f);
    EXPECT_EQ(scene.environment->radiance.at(3, 1, 2), 23.0f);
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_EQ(scene.importReport["environmentMaps"], 1);
    EXPECT_EQ(scene.warnings.count("texels of environment maps set to zero: negative or not a number"), 0u);
}

TEST_F(EnvironmentFile, RadianceFileIsReadExactly) {
    // Mantissas over 256, times 2^(exponent - 128): (1, 0.5, 0.25) and (1024, 0, 3072).
    const std::string texels{'\x80', '\x40', '\x20', '\x81', '\x40', '\x00', '\xc0', '\x8c'};
    write("sky.hdr", radianceFile(texels, "-Y 1 +X 2"));
    const Scene scene = importMap(R"("image": "sky.hdr")");
    ASSERT_TRUE(scene.environment);
    const std::vector<float> expected{1.0f, 0.5f, 0.25f, 1024.0f, 0.0f, 3072.0f};
    EXPECT_EQ(scene.environment->radiance.texels, expected);
}

TEST_F(EnvironmentFile, FaultyTexelsBecomeBlackAndAreCounted) {
    Image image = gradient(3, 2);
    image.at(0, 0, 1) = std::numeric_limits<float>::quiet_NaN();
    image.at(1, 0, 0) = -1.0f;
    image.at(2, 1, 2) = std::numeric_limits<float>::infinity();
    writeMap("sky.exr", image);
    const Scene scene = importMap(R"("image": "sky.exr")");
    ASSERT_TRUE(scene.environment);
    EXPECT_EQ(scene.environment->radiance.at(1, 0, 2), 0.0f);
    EXPECT_EQ(scene.environment->radiance.at(2, 0, 2), 2.0f);
    EXPECT_EQ(scene.warnings.count("texels of environment maps set to zero: negative or not a number"), 3u);
}

TEST_F(EnvironmentFile, ABlackMapIsLeftOut) {
    writeMap("sky.exr", Image(3, 2, 3));
    const Scene scene = importMap(R"("image": "sky.exr")");
    EXPECT_FALSE(scene.environment);
    EXPECT_EQ(scene.warnings.count("environment maps left out: black"), 1u);
}

TEST_F(EnvironmentFile, MistakesAreNamed) {
    writeMap("sky.exr", gradient(2, 1));
    write("sky.png", "\x89PNG\r\n\x1a\n");
    write("cut.hdr", radianceFile(std::string(7, '\x40'), "-Y 1 +X 2"));
    write("vast.hdr", radianceFile(std::string(8, '\x40'), "-Y 30000 +X 30000"));
    write("large.hdr", radianceFile(std::string(8, '\x40'), "-Y 3000 +X 3000"));
    write("odd.hdr", radianceFile(std::string(8, '\x40'), "+X 1 -Y 2"));
    write("cut.exr", "\x76\x2f\x31\x01");
    const std::pair<const char*, const char*> cases[] = {
        {R"("image": "none.exr")", "room.json: lights[0].image: expected an existing file"},
        {R"("image": ".")", "lights[0].image: expected an existing file"},
        {R"("scale": [1, 1, 1])", "missing key \"image\""},
        {R"("image": "sky.exr", "scale": [1, -1, 1])", "lights[0].scale"},
        {R"("image": "sky.exr", "radiance": [1, 1, 1])", "lights[0].radiance: unknown key"},
        {R"("image": "sky.exr"}, {"type": "environment", "image": "sky.exr")", "lights[1].type: expected no second"},
        {R"("image": "sky.png")", "sky.png: neither an EXR nor a Radiance"},
        {R"("image": "cut.hdr")", "cut.hdr: image is truncated"},
        {R"("image": "vast.hdr")", "vast.hdr: 30000 x 30000 texels are more"},
        {R"("image": "large.hdr")", "cannot hold 3000 x 3000"},
        {R"("image": "odd.hdr")", "odd.hdr: not a readable Radiance file"},
        {R"("image": "cut.exr")", "cut.exr: not a readable EXR"},
    };
    for (const auto& [light, message] : cases) EXPECT_THAT(errorWith(light), HasSubstr(message)) << light;
}

}  // namespace
}  // namespace manylight::testing
