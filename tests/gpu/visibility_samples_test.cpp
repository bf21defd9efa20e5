// Further points at which a frame sees pixels: outlines get smoother, light stays what it was.
#include "engine/techniques/reconstruction.h"
#include "shaders/shared/sobol.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <cmath>
#include <numbers>
#include <set>

namespace manylight::test {
namespace {

using VisibilitySamples = GpuTest;

RenderSettings filteredSettings(uint32_t visibilitySamples) {
    RenderSettings settings = plainSettings(64, 48);
    settings.vplCount = settings.pathCount = 256;
    settings.bounceCount = 1;
    settings.interleave = 4;
    settings.filter = Filter::Atrous;
    settings.jitter = true;
    settings.visibilitySamples = visibilitySamples;
    return settings;
}

/// A sphere lit evenly by its own VPLs, with stripes of two albedos where the camera looks: what a pixel should show is
/// their mean over the pixel, times one number.
Scene stripedBall() {
    Scene scene;
    const uint32_t grey = addMaterial(scene, glm::vec3(0.5f));
    addSphere(scene, glm::vec3(0.0f), 0.5f, 5, true, true, grey);
    const uint32_t dark = addMaterial(scene, glm::vec3(0.1f));
    const uint32_t bright = addMaterial(scene, glm::vec3(0.9f));
    for (size_t i = 0; i < scene.triangles.size(); ++i)
        if (scene.vertices[scene.triangles[i].vertex[0]].position.y > 0.1f)
            scene.triangles[i].material = i % 2 == 0 ? dark : bright;
    scene.lights.push_back(spotLight(glm::vec3(0.0f), {0, -1, 0}, glm::vec3(1.0f), 0.8f, 0.8f));
    addCamera(scene, {0.0f, -0.1f, 0.0f}, {0.05f, 0.5f, 0.05f}, 1.0f);
    return finished(std::move(scene));
}

double rootMeanSquare(const Image& a, const Image& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.texels.size(); ++i) sum += std::pow(double{a.texels[i]} - double{b.texels[i]}, 2);
    return std::sqrt(sum / static_cast<double>(a.texels.size()));
}

// Where only outlines are left to chance, points in strata err less than as many frames would: below 1 / sqrt(8).
TEST_F(VisibilitySamples, SmoothOutlinesByRasterAndByRays) {
    const Scene scene = stripedBall();
    RenderSettings whole = filteredSettings(1);
    whole.filter = Filter::Off;
    whole.interleave = 1;
    const Image truth = render(scene, whole, 256);
    for (const GBufferBy gbuffer : {GBufferBy::Raster, GBufferBy::Rays}) {
        SCOPED_TRACE(name(gbuffer));
        RenderSettings one = filteredSettings(1);
        one.gbuffer = gbuffer;
        RenderSettings eight = filteredSettings(8);
        eight.gbuffer = gbuffer;
        const Image smooth = render(scene, eight, 1);
        EXPECT_LT(rootMeanSquare(smooth, truth),
                  rootMeanSquare(render(scene, one, 1), truth) / std::numbers::sqrt2 / 2);
        EXPECT_NEAR(meanOf(smooth), meanOf(truth), 0.005 * meanOf(truth));  // of 3072 pixels, with 8 points each
    }
}

/// A lamp close before one of two walls of different depth: its light falls off within a pixel, and its shadow line
/// too.
Scene lampBeforeWalls() {
    Scene scene;
    const uint32_t grey = addMaterial(scene, glm::vec3(0.5f));
    addQuad(scene, {-0.5f, -0.5f, -0.4f}, {1, 0, 0}, {0, 1, 0}, grey);
    addQuad(scene, {0.02f, -0.2f, 0.0f}, {0.2f, 0, 0}, {0, 0.2f, 0}, grey);
    scene.lights.push_back(pointLight({-0.2f, 0.1f, -0.397f}, glm::vec3(1.0f)));
    scene.lights.push_back(pointLight({0.3f, 0.3f, 0.2f}, glm::vec3(1.0f)));
    addCamera(scene, {0.0f, 0.0f, 0.6f}, {0.05f, -0.05f, 0.0f}, 0.7f);
    return finished(std::move(scene));
}

// Light that has no noise is not borrowed, or its steep falls would be: all light is there, and errors are no larger
// than with one point (by a fifth, for chance).
TEST_F(VisibilitySamples, AskLightsWithoutNoiseAtEveryPoint) {
    const Scene scene = lampBeforeWalls();
    RenderSettings one = filteredSettings(1);
    one.castShadows = true;
    one.shadowRays = 4;
    one.vplCount = 16;
    one.bounceCount = 2;
    for (Lighting lighting : {Lighting::Both, Lighting::Global}) {
        SCOPED_TRACE(name(lighting));
        one.lighting = lighting;
        RenderSettings four = one;
        four.visibilitySamples = 4;
        const Image truth = render(scene, one, 64);
        const double error = rootMeanSquare(render(scene, four, 16), truth);
        EXPECT_LT(error, 1.2 * rootMeanSquare(render(scene, one, 16), truth));
        EXPECT_GT(meanOf(truth), 0.0);
    }
}

/// A wall that fills the picture, half of it in the shadow of something beside it. The lamp is so small that the
/// shadow's edge is half a pixel wide.
Scene shadowEdgeOfALamp() {
    Scene scene;
    const uint32_t grey = addMaterial(scene, glm::vec3(0.5f));
    const uint32_t lamp = addMaterial(scene, glm::vec3(0.0f), glm::vec3(1e5f));
    addQuad(scene, {-0.5f, -0.5f, -0.4f}, {1, 0, 0}, {0, 1, 0}, grey);
    addQuad(scene, {0.3f, -0.5f, -0.1f}, {0.2f, 0, 0}, {0.02f, 1.0f, 0}, grey);
    addQuad(scene, {0.6f, 0.6f, 0.2f}, {0, 0.004f, 0}, {0.004f, 0, 0}, lamp);
    addCamera(scene, {0.0f, 0.0f, 0.3f}, {0.0f, 0.0f, -0.4f}, 0.5f);
    return finished(std::move(scene));
}

// Nor is light of area lights: what is in the shadow at a pixel's first point need not be at its others. Four of them
// leave an edge the error of as many frames, a half, or less as they are stratified; borrowed light would leave it all.
TEST_F(VisibilitySamples, AskAreaLightsAtEveryPoint) {
    const Scene scene = shadowEdgeOfALamp();
    RenderSettings one = filteredSettings(1);
    one.lighting = Lighting::Local;
    one.castShadows = true;
    one.lightSampleCount = 4;
    RenderSettings four = one;
    four.visibilitySamples = 4;
    four.lightSampleCount = 16;
    RenderSettings whole = one;
    whole.filter = Filter::Off;
    whole.interleave = 1;
    const Image truth = render(scene, whole, 256);
    double errorOfOne = 0.0;
    double errorOfFour = 0.0;
    for (const uint32_t seed : {1u, 2u, 3u, 4u}) {
        one.seed = four.seed = seed;
        const Image seen = render(scene, four, 1);
        errorOfOne += rootMeanSquare(render(scene, one, 1), truth);
        errorOfFour += rootMeanSquare(seen, truth);
        EXPECT_NEAR(meanOf(seen), meanOf(truth), 0.01 * meanOf(truth)) << seed;
    }
    EXPECT_LT(errorOfFour, 0.5 * errorOfOne);
}

/// A wall that fills the picture, lit by VPLs on another beside it: the nearer, the brighter.
Scene wallLitFromTheSide() {
    Scene scene;
    const uint32_t grey = addMaterial(scene, glm::vec3(0.5f));
    addQuad(scene, {-0.5f, -0.5f, -0.4f}, {1, 0, 0}, {0, 1, 0}, grey);
    addQuad(scene, {-0.5f, -0.5f, -0.4f}, {0, 1, 0}, {0, 0, 0.5f}, grey);
    scene.lights.push_back(spotLight({0.4f, 0.2f, 0.0f}, {-1, 0, 0}, glm::vec3(1.0f), 0.2f, 0.2f));
    addCamera(scene, {0.0f, 0.0f, 0.3f}, {0.0f, 0.0f, -0.4f}, 0.5f);
    return finished(std::move(scene));
}

// Of a wall of one albedo, two points show its light at the centre of the pixel, which one point shows, and what the
// other has borrowed: by the slopes of the first picture, the light where that other one is.
TEST_F(VisibilitySamples, BorrowLightFromWhereTheyAre) {
    const Scene scene = wallLitFromTheSide();
    for (const uint32_t seed : {1u, 2u, 3u}) {
        RenderSettings settings = filteredSettings(1);
        settings.jitter = false;
        settings.lighting = Lighting::Global;
        settings.seed = seed;
        const Image one = render(scene, settings);
        settings.visibilitySamples = 2;
        const Image two = render(scene, settings);
        const glm::vec2 off = shared::owenScrambledSobol2d(numberOfPoint(2, 0, 1), seed) - glm::vec2(0.5f);
        double product = 0.0;
        double square = 0.0;
        for (uint32_t y = 1; y + 1 < settings.height; ++y)
            for (uint32_t x = 1; x + 1 < settings.width; ++x) {
                const size_t i = 3 * (size_t{y} * settings.width + x);
                const size_t below = 3 * size_t{settings.width};
                const double slopeX = 0.5 * (double{one.texels[i + 3]} - double{one.texels[i - 3]});
                const double slopeY = 0.5 * (double{one.texels[i + below]} - double{one.texels[i - below]});
                const double expected = double{off.x} * slopeX + double{off.y} * slopeY;
                product += 2.0 * (double{two.texels[i]} - double{one.texels[i]}) * expected;
                square += expected * expected;
            }
        ASSERT_GT(square, 0.0);
        EXPECT_NEAR(product / square, 1.0, 0.25) << seed;  // weights of nine pixels make up no plane exactly
    }
}

TEST_F(VisibilitySamples, TheSameSeedGivesTheSameBytes) {
    const Scene scene = everyKindOfLight();
    const Image first = render(scene, filteredSettings(3), 2);
    EXPECT_TRUE(sameBits(render(scene, filteredSettings(3), 2), first));
    EXPECT_FALSE(sameBits(render(scene, filteredSettings(2), 2), first));
}

TEST(VisibilitySampleNumbers, PointsOfAllFramesAreOneSequence) {
    for (const uint32_t count : {1u, 3u, 4u}) {
        std::set<uint32_t> numbers;
        std::set<uint32_t> firstPlaces;
        for (uint32_t frame = 0; frame < 64; ++frame) {
            firstPlaces.insert(numberOfPoint(count, frame, 0) % count);
            for (uint32_t point = 0; point < count; ++point) numbers.insert(numberOfPoint(count, frame, point));
        }
        EXPECT_EQ(numbers.size(), 64u * count);
        EXPECT_EQ(*numbers.rbegin(), 64u * count - 1);
        EXPECT_EQ(firstPlaces.size(), count);
    }
    EXPECT_EQ(numberOfPoint(1, 17, 0), 17u);
}

TEST(VisibilitySampleNumbers, PointsShareTheSamplesOfAreaLights) {
    EXPECT_EQ(lightSamplesOfPoint(12, 3), 4u);
    EXPECT_EQ(lightSamplesOfPoint(4, 3), 2u);
    EXPECT_EQ(lightSamplesOfPoint(1, 3), 1u);
    EXPECT_EQ(lightSamplesOfPoint(16, 1), 16u);
}

TEST(VisibilitySampleNumbers, FurtherPointsComeToAnEnd) {
    EXPECT_EQ(visibilitySamples(4, 0), 4u);
    EXPECT_EQ(visibilitySamples(4, 1u << 10), 1u);
    EXPECT_EQ(visibilitySamples(1, 0), 1u);
}

}  // namespace
}  // namespace manylight::test
