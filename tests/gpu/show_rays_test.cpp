// The heat map of rays, counted by hand.
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

namespace manylight::test {
namespace {

/// A floor seen from below a ceiling, with a lamp between: a VPL on the floor lies in its plane and gives it nothing,
/// one on the ceiling gives light to all of it.
Scene floorAndCeiling() {
    Scene scene = floorFromAbove(0.7f);
    addQuad(scene, {-0.5f, 0.5f, -0.5f}, {1, 0, 0}, {0, 0, 1}, addMaterial(scene, glm::vec3(0.7f)));
    scene.cameras.clear();
    addCamera(scene, {0, 0.45f, 0}, {0, 0, 0}, 1.0f);
    scene.lights.push_back(pointLight({0.1f, 0.3f, 0.05f}, glm::vec3(1.0f)));
    return finished(std::move(scene));
}

/// Three times the share of VPLs that a pixel sends a ray to.
double heatOf(const Image& image, size_t pixel) {
    const float* texel = &image.texels[pixel * 3];
    return double{texel[0]} + double{texel[1]} + double{texel[2]};
}

class ShowRays : public GpuTest {
  protected:
    ShowRays() {
        settings_ = plainSettings(23, 17);
        settings_.vplCount = 200;
        settings_.bounceCount = 5;
        settings_.castShadows = true;
        settings_.show = Show::Rays;
    }
    RenderSettings settings_;
};

TEST_F(ShowRays, CountsTheVplsThatFaceThePixel) {
    const Scene scene = floorAndCeiling();
    settings_.interleave = 3;
    settings_.interleavePhase = 4;
    Renderer renderer(device(), scene, settings_, pipelines());
    for (const uint32_t n : {1u, 3u}) {
        settings_.interleave = n;
        renderer.restart(settings_);
        renderer.keepVpls();
        renderer.renderFrame();
        const std::vector<shared::LightData> vpls = renderer.vpls();
        std::vector<uint32_t> ofSubset(n * n, 0);
        for (size_t i = 0; i < vpls.size(); ++i)
            if (vpls[i].intensity > 0.0f && vpls[i].direction.y < -0.5f) ++ofSubset[i % (n * n)];
        ASSERT_GT(ofSubset[0], 0u);
        const Image image = renderer.radiance();
        for (uint32_t y = 0; y < image.height; ++y)
            for (uint32_t x = 0; x < image.width; ++x) {
                const uint32_t subset = ((y % n) * n + x % n + settings_.interleavePhase) % (n * n);
                ASSERT_NEAR(heatOf(image, y * image.width + x), 3.0 * ofSubset[subset] / 200.0, 1e-5)
                    << x << ", " << y << ", of " << n;
            }
    }
}

TEST_F(ShowRays, DrawnOnesAreAsManyAsAskedForAndDarknessNeedsNone) {
    settings_.shadowRays = 10;
    const Image drawn = render(floorAndCeiling(), settings_);
    const Image dark = render(
        [] {
            Scene scene = floorFromAbove(0.7f);
            scene.lights.push_back(pointLight({0.1f, 0.3f, 0.05f}, glm::vec3(1.0f)));
            return scene;
        }(),
        settings_);
    for (size_t pixel = 0; pixel < size_t{drawn.width} * drawn.height; ++pixel) {
        ASSERT_NEAR(heatOf(drawn, pixel), 3.0 * 10.0 / 200.0, 1e-5) << pixel;
        ASSERT_EQ(heatOf(dark, pixel), 0.0) << pixel;
    }
}

// More VPLs than one dispatch takes: what the first counted is not lost.
TEST_F(ShowRays, LongListsAreCountedInStretches) {
    settings_.vplCount = 20000;
    const Scene scene = floorAndCeiling();
    Renderer renderer(device(), scene, settings_, pipelines());
    renderer.keepVpls();
    renderer.renderFrame();
    uint32_t expected = 0;
    for (const shared::LightData& vpl : renderer.vpls())
        if (vpl.intensity > 0.0f && vpl.direction.y < -0.5f) ++expected;
    EXPECT_GT(expected, 0u);
    EXPECT_NEAR(heatOf(renderer.radiance(), 200), 3.0 * expected / 20000.0, 1e-5);
}

TEST_F(ShowRays, OneInFourPixelsOfAFloorSpeaksForAll) {
    const Scene scene = floorAndCeiling();
    settings_.interleave = 2;
    settings_.gatherStep = 2;
    settings_.filter = Filter::Atrous;
    settings_.shadowRays = 3;
    const Image image = render(scene, settings_);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x)
            ASSERT_NEAR(heatOf(image, y * image.width + x), x % 2 == 0 && y % 2 == 0 ? 3.0 * 3.0 / 200.0 : 0.0, 1e-5)
                << x << ", " << y;
}

}  // namespace
}  // namespace manylight::test
