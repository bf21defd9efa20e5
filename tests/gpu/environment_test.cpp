// Light from environment maps: closed forms, and the VPL techniques against the path tracer under a small bright sun.
#include "shaders/shared/environment.h"
#include "shaders/shared/constants.h"
#include "tests/gpu/test_scenes.h"
#include "tests/gpu/z_test.h"

#include <cmath>

namespace manylight::test {
namespace {

constexpr double kPi = shared::kPi;

/// A map of `radiance(unit direction)`, given a turn that its content makes up for.
template <typename Radiance>
EnvironmentMap mapOf(uint32_t width, uint32_t height, float turn, const Radiance& radiance) {
    EnvironmentMap map{.name = "map", .radiance = Image(width, height, 3), .turn = turn};
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const glm::vec2 uv((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                               (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
            const glm::vec3 value = radiance(glm::dvec3(shared::environmentDirection(uv, turn)));
            for (uint32_t c = 0; c < 3; ++c) map.radiance.at(x, y, c) = value[static_cast<int>(c)];
        }
    return map;
}

constexpr double kSlope[] = {0.3, 0.5, -0.4};  // of radiance along x, y, z

glm::vec3 linearSky(glm::dvec3 direction) {
    return glm::vec3(
        static_cast<float>(1.0 + kSlope[0] * direction.x + kSlope[1] * direction.y + kSlope[2] * direction.z));
}

/// The square at the origin whose front looks along `normal`, filling the picture.
Scene squareTowards(glm::vec3 normal, float albedo) {
    Scene scene;
    const glm::vec3 other = std::abs(normal.y) > 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 u = glm::normalize(glm::cross(other, normal));
    const glm::vec3 v = glm::cross(normal, u);
    addQuad(scene, -0.5f * (u + v), u, v, addMaterial(scene, glm::vec3(albedo)));
    addCamera(scene, 0.5f * normal, glm::vec3(0), 0.8f);
    return finished(std::move(scene));
}

using Environment = GpuTest;

TEST_F(Environment, ALinearSkyGivesEverySideItsIrradiance) {
    // Integral of (1 + a . w) (n . w) over the hemisphere about n: pi + 2 pi / 3 (a . n).
    for (const glm::vec3 normal : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, -1)}) {
        Scene scene = squareTowards(normal, 0.5f);
        scene.environment = mapOf(64, 32, 0.37f, linearSky);
        const double along = kSlope[0] * double{normal.x} + kSlope[1] * double{normal.y} + kSlope[2] * double{normal.z};
        const double expected = 0.5 * (1.0 + 2.0 / 3.0 * along);
        for (const Technique technique : {Technique::Deferred, Technique::PathTracer}) {
            SCOPED_TRACE(name(technique));
            RenderSettings settings = plainSettings(16, 12);
            settings.technique = technique;
            settings.castShadows = true;
            settings.lightSampleCount = 32;
            std::vector<double> means;
            const uint32_t frames = technique == Technique::PathTracer ? 16 : 1;
            forEachSeed(
                scene, settings, 16, [&](Renderer& renderer) { means.push_back(meanOf(renderer.radiance())); }, frames);
            expectMean(means, expected, 0.004);
        }
    }
}

TEST_F(Environment, InAConstantMapAWhiteSurfaceIsAsBrightAsTheMap) {
    Scene scene = squareTowards({0, 1, 0}, 1.0f);
    scene.environment = mapOf(7, 5, 0.0f, [](glm::dvec3) { return glm::vec3(0.5f); });
    scene.lights = {constantLight(glm::vec3(0.25f))};
    for (const Technique technique : {Technique::Deferred, Technique::PathTracer}) {
        RenderSettings settings = plainSettings(16, 12);
        settings.technique = technique;
        settings.castShadows = true;
        settings.lightSampleCount = 64;
        EXPECT_NEAR(meanOf(render(scene, settings, technique == Technique::PathTracer ? 64 : 4)), 0.75, 0.005);
    }
}

TEST_F(Environment, TheCameraSeesTheMapBehindTheScene) {
    Scene scene;
    addQuad(scene, {-0.5f, -0.5f, -0.5f}, {1, 0, 0}, {0, 0, 1}, addMaterial(scene, glm::vec3(0.0f)));
    addCamera(scene, {0.3f, -0.1f, 0.9f}, {0.0f, 0.0f, 0.0f}, 1.3f);
    scene = finished(std::move(scene));
    scene.environment = mapOf(96, 48, 0.2f, linearSky);
    RenderSettings settings = plainSettings(32, 24);
    settings.castShadows = true;
    const Camera& camera = scene.cameras.front();
    const glm::dvec3 right = glm::cross(glm::dvec3(camera.forward), glm::dvec3(camera.up));
    const double halfHeight = std::tan(double{camera.verticalFov} / 2);
    for (const Technique technique : {Technique::Deferred, Technique::Forward, Technique::PathTracer}) {
        SCOPED_TRACE(name(technique));
        settings.technique = technique;
        const Image image = render(scene, settings);
        size_t seen = 0;
        for (uint32_t y = 0; y < image.height; ++y)
            for (uint32_t x = 0; x < image.width; ++x) {
                if (image.at(x, y, 1) == 0.0f) continue;  // the black floor
                const double across = ((x + 0.5) / 16.0 - 1.0) * halfHeight * 32.0 / 24.0;
                const double up = (1.0 - (y + 0.5) / 12.0) * halfHeight;
                const glm::vec3 expected =
                    linearSky(glm::normalize(glm::dvec3(camera.forward) + across * right + up * glm::dvec3(camera.up)));
                ASSERT_NEAR(image.at(x, y, 1), expected.y, 2e-3f) << x << ' ' << y;
                ++seen;
            }
        EXPECT_GT(seen, 300u);
        EXPECT_LT(seen, 32u * 24u - 50u);
    }
}

/// A floor, two walls and a ball of rough metal under a dim sky, with a sun in less than a thousandth of it.
Scene courtUnderTheSun() {
    Scene scene;
    const uint32_t grey = addMaterial(scene, glm::vec3(0.7f));
    const uint32_t red = addMaterial(scene, {0.8f, 0.3f, 0.2f});
    const uint32_t metal = addMaterial(scene, {0.9f, 0.8f, 0.6f});
    scene.materials[metal].metallic = 1.0f;
    scene.materials[metal].roughness = 0.6f;
    addQuad(scene, {-0.5f, -0.3f, -0.5f}, {0, 0, 1}, {1, 0, 0}, grey);
    addQuad(scene, {-0.5f, -0.3f, -0.5f}, {1, 0, 0}, {0, 0.6f, 0}, grey);
    addQuad(scene, {-0.5f, -0.3f, -0.5f}, {0, 0.6f, 0}, {0, 0, 1}, red);
    addSphere(scene, {0.05f, -0.08f, -0.1f}, 0.2f, 2, false, false, metal);
    addCamera(scene, {0.55f, 0.3f, 0.8f}, {-0.1f, -0.12f, -0.15f}, 0.8f);
    scene = finished(std::move(scene));
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.6, 1.0, 0.5));
    scene.environment = mapOf(128, 64, 0.6f, [&](glm::dvec3 direction) {
        if (glm::dot(direction, sun) > 0.9985) return glm::vec3(400.0f, 360.0f, 300.0f);
        return direction.y > 0.0 ? glm::vec3(0.2f, 0.3f, 0.5f) : glm::vec3(0.05f);
    });
    return scene;
}

TEST_F(Environment, UnderASunAllTechniquesAgree) {
    const Scene scene = courtUnderTheSun();
    RenderSettings settings = plainSettings(12, 9);
    settings.castShadows = true;
    settings.russianRoulette = true;
    settings.bounceCount = 4;
    settings.vplCount = 400;
    settings.pathCount = 600;
    settings.lightSampleCount = 8;
    constexpr uint32_t kSeeds = 24;
    RenderSettings reference = settings;
    reference.technique = Technique::PathTracer;
    const PictureSamples truth = samplePictures(scene, reference, {.first = 1000, .count = kSeeds, .frames = 40});
    const PictureSamples deferred = samplePictures(scene, settings, {.count = kSeeds, .frames = 4});
    expectSameMeans(deferred, truth, 0.007);
    EXPECT_TRUE(toldApart(scaled(deferred, 1.03), truth));
    settings.vplCount = 100;
    settings.technique = Technique::ForwardPrepass;
    expectSameMeans(samplePictures(scene, settings, {.count = kSeeds, .frames = 2}), truth, 0.03);
    settings.technique = Technique::Deferred;
    settings.clamp = ClampMode::Compensate;
    settings.clampBound = 1.0f;
    expectSameMeans(samplePictures(scene, settings, {.count = kSeeds, .frames = 4}), truth, 0.03);
}

TEST_F(Environment, PathsThatStartAtAMapCarryItsFlux) {
    // All VPLs of one bounce on a floor of area 1 reflect its irradiance from both sides, times the albedo.
    Scene scene = floorFromAbove(0.5f);
    scene.environment = mapOf(64, 32, 0.1f, linearSky);
    const double irradiance = kPi + 2.0 * kPi / 3.0 * kSlope[1];
    const double below = kPi - 2.0 * kPi / 3.0 * kSlope[1];
    std::vector<double> fluxes;
    RenderSettings settings = plainSettings(4, 4);
    settings.bounceCount = 1;
    settings.pathCount = 4096;
    settings.vplCount = 4096;
    forEachSeed(scene, settings, 16, [&](Renderer& renderer) {
        double flux = 0.0;
        for (const shared::LightData& vpl : renderer.vpls()) flux += kPi * double{vpl.intensity} * double{vpl.colour.x};
        fluxes.push_back(flux);
    });
    expectMean(fluxes, 0.5 * (irradiance + below), 0.02);
}

}  // namespace
}  // namespace manylight::test
