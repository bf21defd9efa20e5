// Direct light against closed forms, at the points that the G-buffer says the pixels show.
#include "engine/techniques/gbuffer_capture.h"
#include "shaders/shared/constants.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <algorithm>
#include <cmath>

namespace manylight::test {
namespace {

constexpr double kPi = shared::kPi;
constexpr float kAlbedo = 0.5f;

GBufferImage gbufferOf(const Scene& scene, const RenderSettings& settings) {
    Renderer renderer(device(), scene, settings, pipelines());
    return captureGBuffer(renderer, scene);
}

/// Every pixel shows the floor, and its radiance is albedo / pi times `irradiance` of its point, in red.
void expectIrradiance(const Scene& scene, const std::function<double(glm::dvec3)>& irradiance,
                      double tolerance = 1e-5) {
    struct Way {
        Technique technique;
        bool shadows;
    };
    for (const auto& [technique, shadows] :
         {Way{Technique::Deferred, false}, Way{Technique::Deferred, true}, Way{Technique::PathTracer, true}}) {
        SCOPED_TRACE(name(technique));
        RenderSettings settings = plainSettings();
        settings.technique = technique;
        settings.castShadows = shadows;
        const Image image = render(scene, settings);
        const GBufferImage gbuffer = gbufferOf(scene, settings);
        for (size_t i = 0; i < gbuffer.texels.size(); ++i) {
            ASSERT_TRUE(gbuffer.texels[i].isSurface);
            const double expected = double{kAlbedo} / kPi * irradiance(gbuffer.texels[i].position);
            ASSERT_NEAR(double{image.texels[3 * i]}, expected, tolerance * expected) << "pixel " << i << shadows;
        }
    }
}

/// Irradiance on an upward plane from a polygon of radiance 1, its corners clockwise seen from below (Lambert 1760).
double irradianceOfPolygon(glm::dvec3 point, const std::vector<glm::dvec3>& corners) {
    double sum = 0.0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 a = glm::normalize(corners[i] - point);
        const glm::dvec3 b = glm::normalize(corners[(i + 1) % corners.size()] - point);
        sum += std::acos(glm::dot(a, b)) * glm::normalize(glm::cross(a, b)).y;
    }
    return 0.5 * std::abs(sum);
}

using DirectLight = GpuTest;

TEST_F(DirectLight, PointOverAPlane) {
    Scene scene = floorFromAbove(kAlbedo);
    const glm::vec3 lamp(0.1f, 0.25f, -0.2f);
    scene.lights.push_back(pointLight(lamp, {0.7f, 0.2f, 0.1f}));
    expectIrradiance(scene, [&](glm::dvec3 x) {
        const glm::dvec3 d = glm::dvec3(lamp) - x;
        return double{0.7f} * d.y / std::pow(glm::dot(d, d), 1.5);
    });
}

TEST_F(DirectLight, PointOfLimitedRangeOverAPlane) {
    Scene scene = floorFromAbove(kAlbedo);
    const glm::vec3 lamp(0.1f, 0.25f, -0.2f);
    scene.lights.push_back(pointLight(lamp, {0.7f, 0.2f, 0.1f}));
    scene.lights.back().range = 0.8f;
    expectIrradiance(scene, [&](glm::dvec3 x) {
        const glm::dvec3 d = glm::dvec3(lamp) - x;
        const double window = 1.0 - std::pow(glm::dot(d, d) / (double{0.8f} * double{0.8f}), 2.0);
        return double{0.7f} * window * d.y / std::pow(glm::dot(d, d), 1.5);
    });
    scene.lights.back().range = 0.2f;  // it does not reach the floor
    EXPECT_EQ(largestOf(render(scene, plainSettings())), 0.0);
}

TEST_F(DirectLight, SpotOverAPlane) {
    Scene scene = floorFromAbove(kAlbedo);
    const glm::dvec3 lamp(0.05, 0.4, -0.1);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(0.2, -1.0, 0.1));
    const double beam = 0.2;
    const double cutoff = 0.5;
    scene.lights.push_back(spotLight(glm::vec3(lamp), glm::vec3(axis), glm::vec3(2.0f), 0.2f, 0.5f));
    RenderSettings settings = plainSettings(64, 48);
    const Image image = render(scene, settings);
    const GBufferImage gbuffer = gbufferOf(scene, settings);
    size_t inBeam = 0;
    size_t inRamp = 0;
    size_t outside = 0;
    for (size_t i = 0; i < gbuffer.texels.size(); ++i) {
        const glm::dvec3 d = lamp - glm::dvec3(gbuffer.texels[i].position);
        const double angle = std::acos(glm::dot(-glm::normalize(d), axis));
        const double share = std::clamp((cutoff - angle) / (cutoff - beam), 0.0, 1.0);
        const double full = double{kAlbedo} / kPi * 2.0 * d.y / std::pow(glm::dot(d, d), 1.5);
        // The ramp is 0.3 rad wide, and Vulkan lets acos() be off by 4096 ulp: 1.2e-4 for these angles.
        ASSERT_NEAR(double{image.texels[3 * i]}, full * share, full * 8e-4) << "angle " << angle;
        inBeam += angle < beam ? 1 : 0;
        inRamp += angle > beam && angle < cutoff ? 1 : 0;
        if (angle > cutoff + 1e-5) {
            ++outside;
            ASSERT_EQ(image.texels[3 * i], 0.0f);
        }
    }
    EXPECT_GT(inBeam, 100u);
    EXPECT_GT(inRamp, 100u);
    EXPECT_GT(outside, 100u);
}

TEST_F(DirectLight, DirectionalOnAPlane) {
    Scene scene = floorFromAbove(kAlbedo);
    scene.lights.push_back(directionalLight({1, -2, 2}, glm::vec3(3.0f)));
    expectIrradiance(scene, [](glm::dvec3) { return 3.0 * 2.0 / 3.0; });
}

TEST_F(DirectLight, LightFromBelowDoesNotPass) {
    Scene scene = floorFromAbove(kAlbedo);
    scene.lights = {directionalLight({0, 1, 0.1f}, glm::vec3(3.0f)), pointLight({0, -0.2f, 0}, glm::vec3(1.0f))};
    EXPECT_EQ(largestOf(render(scene, plainSettings())), 0.0);
}

TEST_F(DirectLight, TheInterpolatedNormalTellsWhichSideTheCameraSees) {
    // As at the rim of a coarse round body: the face is seen, but its normal looks away.
    Scene scene = floorFromAbove(kAlbedo);
    const glm::vec3 normal(-0.6f, 0.8f, 0.0f);
    for (Vertex& vertex : scene.vertices) vertex.normal = normal;
    scene.cameras.clear();
    addCamera(scene, {0.45f, 0.15f, 0.0f}, {0, 0, 0}, 0.2f);
    scene = finished(std::move(scene));
    const glm::vec3 onTheSeenSideOfBoth = glm::normalize(glm::vec3(1.0f, 0.5f, 0.0f));
    for (const glm::vec3 toLight :
         {onTheSeenSideOfBoth, glm::normalize(glm::vec3(-1.0f, 1.0f, 0.0f)),  // before the face
          glm::normalize(glm::vec3(1.0f, -1.0f, 0.0f))}) {                    // behind it
        scene.lights = {directionalLight(-toLight, glm::vec3(3.0f))};
        const bool isLit = toLight == onTheSeenSideOfBoth;
        const double expected = isLit ? double{kAlbedo} / kPi * 3.0 * double{-glm::dot(normal, toLight)} : 0.0;
        for (const GBufferBy gbuffer : {GBufferBy::Raster, GBufferBy::Rays})
            for (const Technique technique :
                 {Technique::Deferred, Technique::Forward, Technique::ForwardPrepass, Technique::PathTracer}) {
                RenderSettings settings = plainSettings(12, 9);
                settings.technique = technique;
                settings.castShadows = true;
                if (technique == Technique::Deferred) settings.gbuffer = gbuffer;
                // Corners keep their normals to 16 bits a coordinate; the cosine is a fifth.
                for (const float texel : render(scene, settings).texels)
                    ASSERT_NEAR(double{texel}, expected, 3e-4 * expected)
                        << name(technique) << ", light from " << toLight.x;
            }
    }
}

TEST_F(DirectLight, SkyOverAPlane) {
    Scene scene = floorFromAbove(kAlbedo);
    scene.lights.push_back(constantLight(glm::vec3(2.0f)));
    RenderSettings settings = plainSettings(8, 8);
    settings.castShadows = true;
    settings.lightSampleCount = 256;
    for (const Technique technique : {Technique::Deferred, Technique::PathTracer}) {
        settings.technique = technique;
        std::vector<double> means;
        const auto use = [&](Renderer& renderer) { means.push_back(meanOf(renderer.radiance())); };
        forEachSeed(scene, settings, 16, use, technique == Technique::PathTracer ? 4 : 1);
        expectMean(means, double{kAlbedo} * 2.0, 0.01);  // irradiance pi L
    }
}

void expectRectangleOverAPlane(Technique technique, uint32_t frames) {
    Scene scene = floorFromAbove(kAlbedo);
    addQuad(scene, {-0.3f, 0.3f, -0.1f}, {0.4f, 0, 0}, {0, 0, 0.3f},
            addMaterial(scene, glm::vec3(0.0f), glm::vec3(1.0f)));
    scene.cameras.clear();
    addCamera(scene, {0.2f, 0.25f, 0.3f}, {-0.1f, 0.0f, -0.1f}, 0.7f);
    const std::vector<glm::dvec3> corners = {{-0.3, 0.3, -0.1}, {0.1, 0.3, -0.1}, {0.1, 0.3, 0.2}, {-0.3, 0.3, 0.2}};
    RenderSettings settings = plainSettings(12, 8);
    settings.castShadows = true;
    settings.lightSampleCount = 64;
    settings.technique = technique;
    const GBufferImage gbuffer = gbufferOf(scene, settings);
    std::vector<std::vector<double>> pixels(gbuffer.texels.size());
    const auto use = [&](Renderer& renderer) {
        const Image image = renderer.radiance();
        for (size_t i = 0; i < pixels.size(); ++i) pixels[i].push_back(double{image.texels[3 * i]});
    };
    forEachSeed(scene, settings, 16, use, frames);
    size_t tested = 0;
    for (size_t i = 0; i < pixels.size(); i += 7) {
        if (!gbuffer.texels[i].isSurface || gbuffer.texels[i].position.y != 0.0f) continue;
        const double irradiance = irradianceOfPolygon(gbuffer.texels[i].position, corners);
        expectMean(pixels[i], double{kAlbedo} / kPi * irradiance, 0.01);
        ++tested;
    }
    EXPECT_GE(tested, 8u);
}

TEST_F(DirectLight, RectangleOverAPlane) { expectRectangleOverAPlane(Technique::Deferred, 1); }

TEST_F(DirectLight, RectangleOverAPlaneByPaths) { expectRectangleOverAPlane(Technique::PathTracer, 32); }

TEST_F(DirectLight, FormFactorOfParallelUnitSquares) {
    // Squares of side 0.5 at distance 0.5: F = 0.199825 (Howell C-11); irradiance averaged over one is F pi L.
    Scene scene;
    addQuad(scene, {-0.25f, 0, -0.25f}, {0, 0, 0.5f}, {0.5f, 0, 0}, addMaterial(scene, glm::vec3(1.0f)));
    addQuad(scene, {-0.25f, 0.5f, -0.25f}, {0.5f, 0, 0}, {0, 0, 0.5f},
            addMaterial(scene, glm::vec3(0.0f), glm::vec3(1.0f)));
    addQuad(scene, {-0.4f, -0.3f, 0}, {0.8f, 0, 0}, {0, 0, 0.1f},
            addMaterial(scene, glm::vec3(0.0f)));  // for the bounds
    // Straight down from just below the lamp: the floor fills the picture, and every pixel has the same footprint.
    addCamera(scene, {0, 0.4999f, 0}, {0, 0, 0}, 2.0f * std::atan(0.25f / 0.4999f));
    scene = finished(std::move(scene));
    RenderSettings settings = plainSettings(32, 32);
    settings.castShadows = true;
    settings.lightSampleCount = 256;
    std::vector<double> means;
    forEachSeed(scene, settings, 16, [&](Renderer& renderer) { means.push_back(meanOf(renderer.radiance())); });
    // Pixel centres are a midpoint rule over the square: good to a few parts in 32^2.
    expectMean(means, 0.199825, 1e-3);
}

TEST_F(DirectLight, EmissionShowsOnTheFrontOnly) {
    Scene scene;
    addQuad(scene, {-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0}, addMaterial(scene, glm::vec3(0.5f), {3, 2, 1}));
    addCamera(scene, {0, 0, 0.5f}, {0, 0, 0}, 0.8f);
    addCamera(scene, {0, 0, -0.5f}, {0, 0, 0}, 0.8f);
    scene = finished(std::move(scene));
    for (const Technique technique : {Technique::Deferred, Technique::Forward, Technique::ForwardPrepass}) {
        RenderSettings settings = plainSettings(8, 8);
        settings.technique = technique;
        const Image front = render(scene, settings);
        for (size_t i = 0; i < front.texels.size(); ++i) ASSERT_EQ(front.texels[i], 3.0f - static_cast<float>(i % 3));
        settings.camera = 1;
        EXPECT_EQ(largestOf(render(scene, settings)), 0.0);
    }
}

TEST_F(DirectLight, AnEmitterLightsNothingBehindIt) {
    Scene scene = floorFromAbove(kAlbedo);
    const uint32_t lamp = addMaterial(scene, glm::vec3(0.0f), glm::vec3(5.0f));
    addQuad(scene, {-0.1f, 0.1f, -0.1f}, {0, 0, 0.2f}, {0.2f, 0, 0}, lamp);  // shines upwards
    RenderSettings settings = plainSettings();
    const Image image = render(scene, settings);
    const GBufferImage gbuffer = gbufferOf(scene, settings);
    size_t floorPixels = 0;
    for (size_t i = 0; i < gbuffer.texels.size(); ++i) {
        const bool isLamp = gbuffer.texels[i].material == lamp;
        ASSERT_EQ(image.texels[3 * i], isLamp ? 5.0f : 0.0f) << i;
        floorPixels += isLamp ? 0 : 1;
    }
    EXPECT_GT(floorPixels, 100u);
    EXPECT_LT(floorPixels, gbuffer.texels.size());
}

}  // namespace
}  // namespace manylight::test
