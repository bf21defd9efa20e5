// The emitter table is a probability distribution, and its powers are those of the textbooks.
#include "engine/scene/emitters.h"

#include "shaders/shared/constants.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace manylight {
namespace {

constexpr double kPi = shared::kPi;

Light pointLight(float intensity) {
    Light light;
    light.emission = glm::vec3(intensity);
    return light;
}

/// A right triangle with legs 2 and 1 (area 1) that emits `radiance`.
Scene emissiveTriangle(float radiance) {
    Scene scene;
    scene.vertices = {{{0, 0, 0}, {}, {}}, {{2, 0, 0}, {}, {}}, {{0, 1, 0}, {}, {}}};
    scene.triangles = {{{0, 1, 2}, 0}};
    Material material;
    material.emittedRadiance = glm::vec3(radiance);
    scene.materials = {material};
    return scene;
}

double powerOf(const Light& light, float sceneRadius) {
    Scene scene;
    scene.lights = {light};
    return buildEmitterTable(scene, sceneRadius).totalPower;
}

TEST(Emitters, PowerOfPointLightIsFourPiTimesItsIntensity) { EXPECT_NEAR(powerOf(pointLight(3), 1), 12 * kPi, 1e-5); }

TEST(Emitters, PowerOfTriangleIsPiTimesAreaTimesRadiance) {
    EXPECT_NEAR(buildEmitterTable(emissiveTriangle(5), 1).totalPower, 5 * kPi, 1e-5);
}

TEST(Emitters, PowerOfDirectionalLightIsThatOfTheDiskItCovers) {
    Light light = pointLight(2);
    light.type = LightType::Directional;
    EXPECT_NEAR(powerOf(light, 3), 2 * kPi * 9, 1e-4);
}

TEST(Emitters, PowerOfEnvironmentIsFourPiTimesTheDisk) {
    Light light = pointLight(2);
    light.type = LightType::Constant;
    EXPECT_NEAR(powerOf(light, 1), 2 * 4 * kPi * kPi, 1e-4);
}

TEST(Emitters, PowerOfSpotEqualsNumericalIntegralOfItsFalloff) {
    Light light = pointLight(1);
    light.type = LightType::Spot;
    const double beam = 0.3;
    const double cutoff = 0.7;
    light.cosBeam = static_cast<float>(std::cos(beam));
    light.cosCutoff = static_cast<float>(std::cos(cutoff));
    double integral = 0.0;
    constexpr int kSteps = 100000;
    for (int i = 0; i < kSteps; ++i) {
        const double angle = cutoff * (i + 0.5) / kSteps;
        const double falloff = angle < beam ? 1.0 : (cutoff - angle) / (cutoff - beam);
        integral += 2.0 * kPi * falloff * std::sin(angle) * cutoff / kSteps;
    }
    EXPECT_NEAR(powerOf(light, 1), integral, 1e-5);
}

TEST(Emitters, ProbabilitiesSumToOneAndAWeakLightKeepsItsDefensiveShare) {
    Scene scene = emissiveTriangle(1e10f);
    scene.lights = {pointLight(1.0f), pointLight(0.0f)};
    const EmitterTable table = buildEmitterTable(scene, 1);
    ASSERT_EQ(table.emitters.size(), 2u);  // the dark one is gone
    EXPECT_EQ(table.deltaLightCount, 1u);
    EXPECT_EQ(table.areaLightCount, 1u);
    EXPECT_NEAR(table.emitters[0].probability, 0.05f, 1e-6);  // 0.1 / 2
    EXPECT_NEAR(table.emitters[0].probability + table.emitters[1].probability, 1.0f, 1e-6);
    EXPECT_EQ(table.emitters[0].areaProbability, 0.0f);
    ASSERT_EQ(table.choices.size(), 2u);
    EXPECT_NEAR(table.choices[0].threshold, 0.1f, 1e-6);  // of half the draws
    EXPECT_EQ(table.choices[0].alias, 1u);
    EXPECT_EQ(table.choices[0].areaThreshold, 0.0f);
    EXPECT_EQ(table.choices[0].areaAlias, 1u);
    EXPECT_EQ(table.emitters[1].areaProbability, 1.0f);
}

TEST(Emitters, AMapStandsForTheConstantLightsToo) {
    Scene scene;
    Light sky = pointLight(2);
    sky.type = LightType::Constant;
    scene.lights = {sky, pointLight(1)};
    scene.environment = EnvironmentMap{.name = "map", .radiance = Image(4, 2, 3)};
    std::ranges::fill(scene.environment->radiance.texels, 1.0f);
    const EmitterTable table = buildEmitterTable(scene, 3.0f, buildEnvironmentTable(scene));
    ASSERT_EQ(table.emitters.size(), 2u);
    EXPECT_EQ(table.deltaLightCount, 1u);
    EXPECT_EQ(table.environmentRadiance, glm::vec3(0.0f));
    EXPECT_NEAR(table.totalPower, 4 * kPi + 3 * 4 * kPi * kPi * 9, 1e-3);
    EXPECT_NEAR(table.environmentProbability, double{table.emitters[1].probability}, 1e-9);
}

TEST(Emitters, NoLightGivesAnEmptyTable) { EXPECT_TRUE(buildEmitterTable(emissiveTriangle(0), 1).emitters.empty()); }

}  // namespace
}  // namespace manylight
