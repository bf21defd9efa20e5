// Inside a diffuse sphere cos cos / d^2 is 1 / (4 R^2) for any two points, so any VPL set gives the exact picture: a
// light pi R^2 at the centre and an albedo of 1/2 give radiance 1/2 directly and 1/2^(k+1) after k bounces.
#include "shaders/shared/constants.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <cmath>

namespace manylight::test {
namespace {

constexpr float kRadius = 0.5f;

Scene sphereScene() {
    Scene scene;
    addSphere(scene, glm::vec3(0.0f), kRadius, 5, true, false, addMaterial(scene, glm::vec3(0.5f)));
    scene.lights.push_back(pointLight(glm::vec3(0.0f), glm::vec3(shared::kPi * kRadius * kRadius)));
    addCamera(scene, {0.1f, 0.05f, 0.2f}, {-0.2f, -0.1f, -1.0f}, 1.4f);
    return finished(std::move(scene));
}

/// The largest angle by which a facet's normal misses the direction of its corners. Every error of the tessellation
/// is of the order of its square: a facet is nearer to the centre by 1 - cos(tilt) and tilted by at most that.
double tessellationTilt(const Scene& scene) {
    double largest = 0.0;
    for (const Triangle& triangle : scene.triangles) {
        const glm::dvec3 a = scene.vertices[triangle.vertex[0]].position;
        const glm::dvec3 b = scene.vertices[triangle.vertex[1]].position;
        const glm::dvec3 c = scene.vertices[triangle.vertex[2]].position;
        const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
        largest = std::max(largest, std::acos(-glm::dot(normal, glm::normalize(a))));
    }
    return largest;
}

double expectedRadiance(int bounces) { return 1.0 - std::pow(0.5, bounces + 1); }

RenderSettings sphereSettings(int bounces, bool shadows) {
    RenderSettings settings = plainSettings(32, 32);
    settings.vplCount = bounces == 0 ? 0 : 2048;
    settings.pathCount = 512;
    settings.bounceCount = bounces;
    settings.castShadows = shadows;
    return settings;
}

using IntegratingSphere = GpuTest;

TEST_F(IntegratingSphere, DirectLightIsOneHalfInEveryPixel) {
    const Scene scene = sphereScene();
    // At an angle theta off the facet's normal the facet receives cos^3(theta) / cos^2(tilt) of the sphere's
    // irradiance.
    const double tolerance = 0.5 * (1.0 / std::pow(std::cos(tessellationTilt(scene)), 2.0) - 1.0) + 1e-6;
    ASSERT_LT(tolerance, 2e-3);
    for (const bool shadows : {false, true}) {
        const Image image = render(scene, sphereSettings(0, shadows));
        for (const float radiance : image.texels) ASSERT_NEAR(double{radiance}, 0.5, tolerance) << shadows;
    }
}

TEST_F(IntegratingSphere, EveryBounceAddsHalfOfTheOneBefore) {
    const Scene scene = sphereScene();
    const double tilt = tessellationTilt(scene);
    for (int bounces = 1; bounces <= 4; ++bounces) {
        const double expected = expectedRadiance(bounces);
        const Image image = render(scene, sphereSettings(bounces, false));
        // Each bounce meets the tessellation once more.
        EXPECT_NEAR(meanOf(image), expected, tilt * tilt * (bounces + 1)) << bounces;
        // A single pixel can have a VPL on the facet beside its own, where G is not what it is on the sphere.
        for (const float radiance : image.texels) ASSERT_NEAR(double{radiance}, expected, 0.03) << bounces;
    }
}

TEST_F(IntegratingSphere, NothingInAConvexBodyIsInShadow) {
    const Scene scene = sphereScene();
    const Image lit = render(scene, sphereSettings(3, false));
    const Image shadowed = render(scene, sphereSettings(3, true));
    for (size_t i = 0; i < lit.texels.size(); ++i) ASSERT_NEAR(shadowed.texels[i], lit.texels[i], 2e-6f) << i;
}

TEST_F(IntegratingSphere, RussianRouletteKeepsTheMean) {
    const Scene scene = sphereScene();
    RenderSettings settings = sphereSettings(-1, true);
    settings.russianRoulette = true;
    std::vector<double> means;
    forEachSeed(scene, settings, 16, [&](Renderer& renderer) {
        EXPECT_LT(renderer.status().vplsTraced, settings.vplCount) << "all vertices are to be in the list";
        means.push_back(meanOf(renderer.radiance()));
    });
    expectMean(means, 1.0, 4e-3);
}

TEST_F(IntegratingSphere, FourLightsMakeOne) {
    Scene scene = sphereScene();
    const Image one = render(scene, sphereSettings(0, false));
    scene.lights = std::vector<Light>(4, pointLight(glm::vec3(0.0f), scene.lights[0].emission * 0.25f));
    const Image four = render(scene, sphereSettings(0, false));
    for (size_t i = 0; i < one.texels.size(); ++i) ASSERT_NEAR(four.texels[i], one.texels[i], 1e-6f) << i;
}

TEST_F(IntegratingSphere, ASphereThatEmitsOneHalfShinesWithOne) {
    Scene scene = sphereScene();
    scene.lights.clear();
    scene.materials[0].emittedRadiance = glm::vec3(0.5f);
    RenderSettings settings = sphereSettings(-1, true);
    settings.russianRoulette = true;
    settings.lightSampleCount = 256;
    std::vector<double> means;
    forEachSeed(scene, settings, 16, [&](Renderer& renderer) { means.push_back(meanOf(renderer.radiance())); });
    expectMean(means, 1.0, 4e-3);
}

}  // namespace
}  // namespace manylight::test
