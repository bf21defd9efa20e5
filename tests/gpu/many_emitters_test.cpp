// Thousands of emissive triangles: each has its share of light paths and samples.
#include "engine/scene/emitters.h"
#include "shaders/shared/constants.h"
#include "tests/gpu/test_scenes.h"
#include "tests/gpu/z_test.h"

#include <random>

namespace manylight::test {
namespace {

constexpr double kPi = shared::kPi;
constexpr float kAlbedo = 0.6f;
constexpr uint32_t kEmitters = 5000;

/// A closed room of one albedo with small lamps under the ceiling; one in eight is 30 times as bright as the others.
Scene lampsUnderTheCeiling() {
    Scene scene = closedBox(glm::vec3(kAlbedo));
    const uint32_t dim = addMaterial(scene, glm::vec3(kAlbedo), {1.0f, 2.0f, 3.0f});
    const uint32_t bright = addMaterial(scene, glm::vec3(kAlbedo), {90.0f, 60.0f, 30.0f});
    std::mt19937 random(9);
    std::uniform_real_distribution<float> place(-0.49f, 0.48f);
    std::uniform_real_distribution<float> size(0.002f, 0.009f);
    for (uint32_t i = 0; i < kEmitters; ++i) {
        const glm::vec3 corner(place(random), 0.47f + 0.02f * place(random), place(random));
        const auto first = static_cast<uint32_t>(scene.vertices.size());
        scene.vertices.push_back({corner, {}, {}});
        scene.vertices.push_back({corner + glm::vec3(size(random), 0, 0), {}, {}});
        scene.vertices.push_back({corner + glm::vec3(0, 0, size(random)), {}, {}});  // front side down
        scene.triangles.push_back({{first, first + 1, first + 2}, i % 8 == 0 ? bright : dim});
    }
    return scene;
}

double fluxOf(const Scene& scene) {
    double flux = 0.0;
    for (const Triangle& triangle : scene.triangles) {
        const glm::vec3 radiance = scene.materials[triangle.material].emittedRadiance;
        const glm::dvec3 p0 = scene.vertices[triangle.vertex[0]].position;
        const glm::dvec3 e1 = glm::dvec3(scene.vertices[triangle.vertex[1]].position) - p0;
        const glm::dvec3 e2 = glm::dvec3(scene.vertices[triangle.vertex[2]].position) - p0;
        flux += kPi * 0.5 * glm::length(glm::cross(e1, e2)) *
                (double{radiance.x} + double{radiance.y} + double{radiance.z}) / 3.0;
    }
    return flux;
}

using ManyEmitters = GpuTest;

TEST_F(ManyEmitters, LightPathsCarryTheirWholeFlux) {
    const Scene scene = lampsUnderTheCeiling();
    const double flux = fluxOf(scene);
    EXPECT_NEAR(buildEmitterTable(scene, 1.0f).totalPower, flux, 1e-5 * flux);
    EXPECT_EQ(buildEmitterTable(scene, 1.0f).emitters.size(), kEmitters);
    RenderSettings settings = plainSettings(4, 4);
    settings.bounceCount = 1;
    settings.pathCount = 4096;
    settings.vplCount = 4096;
    std::vector<double> sums;
    forEachSeed(scene, settings, 16, [&](Renderer& renderer) {
        double sum = 0.0;
        for (const shared::LightData& vpl : renderer.vpls())
            sum += kPi * double{vpl.intensity} * (double{vpl.colour.x} + double{vpl.colour.y} + double{vpl.colour.z}) /
                   3.0;
        sums.push_back(sum);
    });
    expectMean(sums, double{kAlbedo} * flux, 0.003 * flux);
}

TEST_F(ManyEmitters, VplsAndThePathTracerAgree) {
    const Scene scene = lampsUnderTheCeiling();
    RenderSettings settings = plainSettings(12, 9);
    settings.castShadows = true;
    settings.bounceCount = 2;
    settings.vplCount = 400;
    settings.lightSampleCount = 16;
    constexpr uint32_t kSeeds = 16;
    RenderSettings reference = settings;
    reference.technique = Technique::PathTracer;
    const PictureSamples truth = samplePictures(scene, reference, {.first = 1000, .count = kSeeds, .frames = 64});
    const PictureSamples deferred = samplePictures(scene, settings, {.count = kSeeds, .frames = 4});
    expectSameMeans(deferred, truth, 0.01);
    EXPECT_TRUE(toldApart(scaled(deferred, 1.05), truth));
}

}  // namespace
}  // namespace manylight::test
