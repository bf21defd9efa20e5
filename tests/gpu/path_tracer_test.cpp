// The path tracer against closed forms: the reference must not need one itself.
#include "shaders/shared/constants.h"
#include "shaders/shared/path_trace.h"
#include "tests/gpu/test_scenes.h"
#include "tests/gpu/z_test.h"

#include <cmath>

namespace manylight::test {
namespace {

RenderSettings pathSettings(int bounces, bool russianRoulette, uint32_t width = 12, uint32_t height = 9) {
    RenderSettings settings = plainSettings(width, height);
    settings.technique = Technique::PathTracer;
    settings.castShadows = true;
    settings.bounceCount = bounces;
    settings.russianRoulette = russianRoulette;
    return settings;
}

std::vector<double> meansOf(const Scene& scene, const RenderSettings& settings, uint32_t frames = 1) {
    std::vector<double> means;
    forEachSeed(
        scene, settings, 16, [&](Renderer& renderer) { means.push_back(meanOf(renderer.radiance())); }, frames);
    return means;
}

Scene furnace(float albedo) { return closedBox(glm::vec3(albedo), glm::vec3(1.0f)); }

/// Emission, and light scattered once to `bounces` + 1 times.
double furnaceRadiance(float albedo, int bounces) {
    const double a = double{albedo};
    return (1.0 - std::pow(a, bounces + 2)) / (1.0 - a);
}

class PathTracerFurnace : public GpuTest, public ::testing::WithParamInterface<float> {};

INSTANTIATE_TEST_SUITE_P(Albedos, PathTracerFurnace, ::testing::Values(0.5f, 0.8f, 0.9f, 0.99f, 0.999f));

TEST_P(PathTracerFurnace, ShinesAsTheGeometricSeriesSays) {
    const float albedo = GetParam();
    for (const int bounces : {3, 1023}) {
        SCOPED_TRACE(bounces);
        const double expected = furnaceRadiance(albedo, bounces);
        expectMean(meansOf(furnace(albedo), pathSettings(bounces, false, 8, 6)), expected, 0.01 * expected);
    }
}

TEST_P(PathTracerFurnace, RussianRouletteKeepsItsRadiance) {
    const double expected = furnaceRadiance(GetParam(), 1023);
    expectMean(meansOf(furnace(GetParam()), pathSettings(1023, true), 2), expected, 0.04 * expected);
}

using PathTracer = GpuTest;

TEST_F(PathTracer, EveryScatteringLeavesTheShareOfTheAlbedo) {
    constexpr float kAlbedo = 0.7f;
    std::vector<double> before = meansOf(furnace(kAlbedo), pathSettings(0, false), 4);
    for (int bounces = 1; bounces <= 5; ++bounces) {
        SCOPED_TRACE(bounces);
        // The same seeds: paths of the same beginning.
        const std::vector<double> means = meansOf(furnace(kAlbedo), pathSettings(bounces, false), 4);
        std::vector<double> last;
        for (size_t i = 0; i < means.size(); ++i) last.push_back(means[i] - before[i]);
        const double expected = std::pow(double{kAlbedo}, bounces + 1);
        expectMean(last, expected, 0.01 * expected);
        before = means;
    }
}

TEST_F(PathTracer, LightAndGlobalMakeBoth) {
    const Scene scene = everyKindOfLight();
    RenderSettings settings = pathSettings(-1, true, 24, 18);
    const Image both = render(scene, settings, 2);
    settings.lighting = Lighting::Local;
    const Image local = render(scene, settings, 2);
    settings.lighting = Lighting::Global;
    const Image global = render(scene, settings, 2);
    EXPECT_GT(meanOf(global), 0.01 * meanOf(local));
    for (size_t i = 0; i < both.texels.size(); ++i)
        ASSERT_NEAR(both.texels[i], local.texels[i] + global.texels[i], 2e-6f * (1.0f + both.texels[i])) << i;
}

TEST_F(PathTracer, PathsThatAreSuspendedGoOnAsIfNothingHadBeen) {
    // Walls so dark that no path gets far: what further dispatches and bands of the picture could add is nothing.
    const Scene scene = furnace(0.1f);
    constexpr int kOneDispatch = static_cast<int>(shared::kSurfacesPerDispatch) - 2;
    for (const glm::uvec2 size : {glm::uvec2(16, 12), glm::uvec2(540, 500)}) {
        const Image atOnce = render(scene, pathSettings(kOneDispatch, true, size.x, size.y));
        EXPECT_TRUE(sameBits(render(scene, pathSettings(200, true, size.x, size.y)), atOnce)) << size.x;
    }
    EXPECT_GT(540u * 500u, shared::kPathStatesPerBand) << "the picture has more than one band";
}

TEST_F(PathTracer, IntegratingSphere) {
    constexpr float kRadius = 0.5f;
    Scene scene;
    addSphere(scene, glm::vec3(0.0f), kRadius, 5, true, false, addMaterial(scene, glm::vec3(0.5f)));
    addCamera(scene, {0.1f, 0.05f, 0.2f}, {-0.2f, -0.1f, -1.0f}, 1.4f);
    scene.lights.push_back(pointLight(glm::vec3(0.0f), glm::vec3(shared::kPi * kRadius * kRadius)));
    scene = finished(std::move(scene));
    // The facets' tilt is below 0.03, and errors of the tessellation are of the order of its square.
    constexpr double kTessellation = 1e-3;
    for (int bounces = 0; bounces <= 3; ++bounces) {
        const std::vector<double> means = meansOf(scene, pathSettings(bounces, false));
        const double expected = 1.0 - std::pow(0.5, bounces + 1);
        for (const double mean : means) EXPECT_NEAR(mean, expected, (bounces + 1) * kTessellation) << bounces;
    }
}

/// An up-facing square of side 0.5 at y = 0, albedo 1, exactly fills the picture of a camera 0.2499 above it.
Scene squareFromAbove() {
    Scene scene;
    addQuad(scene, {-0.25f, 0, -0.25f}, {0, 0, 0.5f}, {0.5f, 0, 0}, addMaterial(scene, glm::vec3(1.0f)));
    addQuad(scene, {-0.4f, -0.3f, 0}, {0.8f, 0, 0}, {0, 0, 0.1f},
            addMaterial(scene, glm::vec3(0.0f)));  // for the bounds
    addCamera(scene, {0, 0.2499f, 0}, {0, 0, 0}, 2.0f * std::atan(0.25f / 0.2499f));
    return scene;
}

RenderSettings formFactorSettings() {
    RenderSettings settings = pathSettings(0, false, 32, 32);
    settings.jitter = true;  // every point of the receiver
    return settings;
}

TEST_F(PathTracer, FormFactorOfParallelSquares) {
    Scene scene = squareFromAbove();
    addQuad(scene, {-0.25f, 0.5f, -0.25f}, {0.5f, 0, 0}, {0, 0, 0.5f},
            addMaterial(scene, glm::vec3(0.0f), glm::vec3(1.0f)));
    expectMean(meansOf(finished(std::move(scene)), formFactorSettings(), 8), 0.199825, 2e-4);
}

TEST_F(PathTracer, FormFactorOfSquaresThatShareAnEdge) {
    // The weak singularity along the edge is what multiple importance sampling is for.
    Scene scene = squareFromAbove();
    addQuad(scene, {0.25f, 0, -0.25f}, {0, 0, 0.5f}, {0, 0.5f, 0},
            addMaterial(scene, glm::vec3(0.0f), glm::vec3(1.0f)));
    expectMean(meansOf(finished(std::move(scene)), formFactorSettings(), 16), 0.200044, 5e-4);
}

/// A regular polygon of 128 corners with the area of a disk of that radius, facing up or down.
void addDisk(Scene& scene, float height, double radius, bool facesUp, uint32_t material) {
    constexpr int kCorners = 128;
    const double step = 2.0 * shared::kPi / kCorners;
    const double corner = radius * std::sqrt(step / std::sin(step));
    const auto first = static_cast<uint32_t>(scene.vertices.size());
    for (int i = 0; i < kCorners; ++i) {
        const double angle = facesUp ? -i * step : i * step;
        scene.vertices.push_back(
            {{static_cast<float>(corner * std::cos(angle)), height, static_cast<float>(corner * std::sin(angle))},
             glm::vec3(0.0f),
             {0, 0}});
    }
    for (uint32_t i = 1; i + 1 < kCorners; ++i)
        scene.triangles.push_back({{first, first + i, first + i + 1}, material});
}

TEST_F(PathTracer, FormFactorOfCoaxialDisks) {
    constexpr double kRadius = 0.25;
    Scene scene;
    addDisk(scene, 0.0f, kRadius, true, addMaterial(scene, glm::vec3(1.0f)));
    addDisk(scene, 0.25f, kRadius, false, addMaterial(scene, glm::vec3(0.0f), glm::vec3(1.0f)));
    addQuad(scene, {-0.5f, -0.3f, -0.3f}, {1.0f, 0, 0}, {0, 0, 0.6f}, addMaterial(scene, glm::vec3(0.0f)));
    // The picture is a square of side 0.52, of which the disk is a part.
    addCamera(scene, {0, 0.2499f, 0}, {0, 0, 0}, 2.0f * std::atan(0.26f / 0.2499f));
    std::vector<double> factors = meansOf(finished(std::move(scene)), formFactorSettings(), 12);
    for (double& factor : factors) factor *= 0.52 * 0.52 / (double{shared::kPi} * kRadius * kRadius);
    // Equal areas leave errors of the shape, of the order of the sagitta of one side over the radius: 3e-4.
    expectMean(factors, 0.381966, 5e-4);
}

/// Radiance that a patch of albedo 1 shows of light from the other, of radiance 1, averaged: its form factor. The
/// patches are a floor of side 0.2 and a wall of side 0.4 beside it.
PictureSamples factorBetween(bool fromFloor, Technique technique) {
    Scene scene;
    const uint32_t receiver = addMaterial(scene, glm::vec3(1.0f));
    const uint32_t emitter = addMaterial(scene, glm::vec3(0.0f), glm::vec3(1.0f));
    addQuad(scene, {-0.1f, 0, -0.1f}, {0, 0, 0.2f}, {0.2f, 0, 0}, fromFloor ? receiver : emitter);
    addQuad(scene, {0.3f, 0.05f, -0.2f}, {0, 0, 0.4f}, {0, 0.4f, 0}, fromFloor ? emitter : receiver);
    addQuad(scene, {-0.5f, -0.3f, -0.3f}, {1.0f, 0, 0}, {0, 0, 0.6f}, addMaterial(scene, glm::vec3(0.0f)));
    if (fromFloor)
        addCamera(scene, {0, 0.05f, 0}, {0, 0, 0}, 2.0f * std::atan(0.1f / 0.05f));
    else
        addCamera(scene, {0.25f, 0.25f, 0}, {0.3f, 0.25f, 0}, 2.0f * std::atan(0.2f / 0.05f));
    RenderSettings settings = formFactorSettings();
    settings.width = settings.height = 24;
    settings.technique = technique;
    settings.lightSampleCount = 4;
    return samplePictures(finished(std::move(scene)), settings, {.first = fromFloor ? 0u : 100u, .frames = 4});
}

TEST_F(PathTracer, FormFactorsAreReciprocal) {
    constexpr double kRatioOfAreas = 4.0;
    for (const Technique technique : {Technique::PathTracer, Technique::Deferred}) {
        SCOPED_TRACE(name(technique));
        const std::vector<double> fromFloor = factorBetween(true, technique).mean;
        std::vector<double> difference = factorBetween(false, technique).mean;
        ASSERT_GT(fromFloor[0], 0.02);
        for (size_t i = 0; i < difference.size(); ++i)
            difference[i] = kRatioOfAreas * difference[i] / fromFloor[i] - 1.0;
        expectMean(difference, 0.0, 0.004);
    }
}

TEST_F(PathTracer, SkyThroughTheRoofIsThatOfTheVpls) {
    // The sky, met by the camera, by scattered paths and by samples of its own, and at the last sent down as VPLs.
    Scene scene = unevenBox();
    scene.triangles.erase(scene.triangles.begin() + 6, scene.triangles.begin() + 8);  // the roof
    scene.lights = {constantLight({1.0f, 1.5f, 2.0f})};
    RenderSettings settings = pathSettings(6, true);
    const PictureSamples truth = samplePictures(scene, settings, {.first = 1000, .frames = 48});
    settings.technique = Technique::Deferred;
    settings.vplCount = 400;
    settings.lightSampleCount = 32;
    const PictureSamples deferred = samplePictures(scene, settings, {.frames = 4});
    expectSameMeans(deferred, truth, 0.008);
    EXPECT_TRUE(toldApart(scaled(deferred, 1.05), truth));
}

}  // namespace
}  // namespace manylight::test
