// In a closed room of one albedo a, the VPLs of bounce k carry the flux Phi a^k, whatever the room looks like.
#include "engine/core/error.h"
#include "shaders/shared/constants.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace manylight::test {
namespace {

constexpr double kPi = shared::kPi;

/// Flux that leaves the VPLs, pi * intensity, mean of the channels, by bounce; entry 0 is the first bounce.
std::vector<double> fluxByBounce(const std::vector<shared::LightData>& vpls) {
    std::vector<double> flux(kMaxBounces, 0.0);
    for (const shared::LightData& vpl : vpls) {
        if (vpl.intensity == 0.0f) continue;
        const double mean = (double{vpl.colour.x} + double{vpl.colour.y} + double{vpl.colour.z}) / 3.0;
        flux.at(vpl.depth - 1) += kPi * double{vpl.intensity} * mean;
    }
    return flux;
}

double totalFlux(const std::vector<shared::LightData>& vpls) {
    double sum = 0.0;
    for (const double flux : fluxByBounce(vpls)) sum += flux;
    return sum;
}

RenderSettings energySettings(uint32_t paths, uint32_t vpls, int bounces, bool russianRoulette) {
    RenderSettings settings = plainSettings(4, 4);
    settings.pathCount = paths;
    settings.vplCount = vpls;
    settings.bounceCount = bounces;
    settings.russianRoulette = russianRoulette;
    return settings;
}

/// Every vertex of every path is in the list, so nothing is left to chance.
void expectExactFlux(const Scene& scene, double flux, double albedo, uint32_t paths = 500) {
    constexpr int kBounces = 5;
    const VplList list =
        renderVpls(scene, energySettings(paths, paths * static_cast<uint32_t>(kBounces) + 100, kBounces, false));
    EXPECT_EQ(list.status.vplsTraced, paths * static_cast<uint32_t>(kBounces)) << "a path left the closed room";
    EXPECT_EQ(list.status.vplsShaded, list.status.vplsTraced);
    EXPECT_EQ(list.status.pathsTruncated, paths);
    const std::vector<double> byBounce = fluxByBounce(list.vpls);
    for (int k = 1; k <= kBounces; ++k) {
        const double expected = flux * std::pow(albedo, k);
        EXPECT_NEAR(byBounce[static_cast<size_t>(k - 1)], expected, 3e-6 * expected) << "bounce " << k;
    }
}

using VplEnergy = GpuTest;

TEST_F(VplEnergy, PointLight) {
    Scene scene = closedBox(glm::vec3(0.75f));
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(2.0f)));
    expectExactFlux(scene, 4.0 * kPi * 2.0, 0.75);
}

TEST_F(VplEnergy, SeveralBatchesOfPaths) {
    Scene scene = closedBox(glm::vec3(0.75f));
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(2.0f)));
    expectExactFlux(scene, 4.0 * kPi * 2.0, 0.75, 9000);
}

TEST_F(VplEnergy, TwoPointLightsOfAnyRatio) {
    Scene scene = closedBox(glm::vec3(0.5f));
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(3.0f)));
    scene.lights.push_back(pointLight({-0.3f, 0.0f, 0.1f}, glm::vec3(1e-3f)));
    std::vector<double> first;
    forEachSeed(scene, energySettings(512, 2048, 2, false), 16,
                [&](Renderer& renderer) { first.push_back(fluxByBounce(renderer.vpls())[0]); });
    const double expected = 4.0 * kPi * 3.001 * 0.5;
    expectMean(first, expected, 0.01 * expected);
}

TEST_F(VplEnergy, SpotWithAHardEdge) {
    Scene scene = closedBox(glm::vec3(0.75f));
    scene.lights.push_back(spotLight({0, 0.2f, 0}, {0.3f, -1, 0.2f}, glm::vec3(2.0f), 0.6f, 0.6f));
    expectExactFlux(scene, 2.0 * kPi * (1.0 - std::cos(0.6)) * 2.0, 0.75);
}

TEST_F(VplEnergy, SpotWithASoftEdge) {
    constexpr double kBeam = 0.3;
    constexpr double kCutoff = 0.8;
    Scene scene = closedBox(glm::vec3(0.5f));
    scene.lights.push_back(spotLight({0, 0.2f, 0}, {0.3f, -1, 0.2f}, glm::vec3(1.0f), 0.3f, 0.8f));
    // Integral of a falloff linear in the angle, by the midpoint rule.
    double solidAngle = 2.0 * kPi * (1.0 - std::cos(kBeam));
    for (int i = 0; i < 1000; ++i) {
        const double share = (i + 0.5) / 1000.0;
        solidAngle +=
            2.0 * kPi * std::sin(kBeam + share * (kCutoff - kBeam)) * (1.0 - share) * (kCutoff - kBeam) / 1000.0;
    }
    std::vector<double> first;
    forEachSeed(scene, energySettings(512, 512, 1, false), 16,
                [&](Renderer& renderer) { first.push_back(fluxByBounce(renderer.vpls())[0]); });
    expectMean(first, 0.5 * solidAngle, 0.01 * solidAngle);
}

TEST_F(VplEnergy, AreaLight) {
    Scene scene = closedBox(glm::vec3(0.75f));
    // Just below the ceiling, and of its albedo: a path that meets the lamp goes on as from a wall.
    addQuad(scene, {-0.1f, 0.5f - 1e-4f, -0.2f}, {0.2f, 0, 0}, {0, 0, 0.4f},
            addMaterial(scene, glm::vec3(0.75f), glm::vec3(5.0f)));
    expectExactFlux(scene, kPi * 0.2 * 0.4 * 5.0, 0.75);
}

TEST_F(VplEnergy, WallsThatEmit) { expectExactFlux(closedBox(glm::vec3(0.5f), glm::vec3(2.0f)), kPi * 6.0 * 2.0, 0.5); }

TEST_F(VplEnergy, DirectionalLightMeetsTheProjectedArea) {
    Scene scene = closedBox(glm::vec3(0.5f));
    const glm::vec3 direction = glm::normalize(glm::vec3(1, -2, 3));
    scene.lights.push_back(directionalLight(direction, glm::vec3(2.0f)));
    std::vector<double> first;
    forEachSeed(scene, energySettings(1024, 1024, 1, false), 16,
                [&](Renderer& renderer) { first.push_back(fluxByBounce(renderer.vpls())[0]); });
    const double projected = (1.0 + 2.0 + 3.0) / std::sqrt(14.0);  // a unit cube's: sum of |components|
    expectMean(first, 0.5 * 2.0 * projected, 0.02);
}

TEST_F(VplEnergy, ConstantLightMeetsAConvexBodyAllAround) {
    Scene scene = closedBox(glm::vec3(0.5f));
    scene.lights.push_back(constantLight(glm::vec3(2.0f)));
    std::vector<double> first;
    forEachSeed(scene, energySettings(1024, 1024, 1, false), 16,
                [&](Renderer& renderer) { first.push_back(fluxByBounce(renderer.vpls())[0]); });
    expectMean(first, 0.5 * kPi * 2.0 * 6.0, 0.2);
}

TEST_F(VplEnergy, RussianRouletteKeepsTheFluxOfEveryBounce) {
    constexpr double kAlbedo = 0.6;
    Scene scene = closedBox({0.6f, 0.6f, 0.6f});
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(1.0f)));
    std::vector<std::vector<double>> byBounce(6);
    forEachSeed(scene, energySettings(512, 4096, -1, true), 16, [&](Renderer& renderer) {
        const std::vector<double> flux = fluxByBounce(renderer.vpls());
        for (size_t k = 0; k < byBounce.size(); ++k) byBounce[k].push_back(flux[k]);
    });
    for (size_t k = 0; k < byBounce.size(); ++k) {
        SCOPED_TRACE(k + 1);
        const double expected = 4.0 * kPi * std::pow(kAlbedo, static_cast<double>(k + 1));
        expectMean(byBounce[k], expected, 0.05 * expected);
    }
}

TEST_F(VplEnergy, RussianRouletteChangesNoExpectationWhereChannelsDiffer) {
    const Scene scene = unevenBox();
    std::vector<double> difference;
    std::vector<double> without;
    forEachSeed(scene, energySettings(1024, 1024 * 8, 8, false), 16,
                [&](Renderer& renderer) { without.push_back(totalFlux(renderer.vpls())); });
    size_t seed = 0;
    forEachSeed(scene, energySettings(1024, 1024 * 8, 8, true), 16,
                [&](Renderer& renderer) { difference.push_back(totalFlux(renderer.vpls()) - without[seed++]); });
    expectMean(difference, 0.0, 0.01 * without[0]);
}

TEST_F(VplEnergy, ASampleOfTheVerticesKeepsTheirExpectation) {
    const Scene scene = unevenBox();
    std::vector<double> all;
    forEachSeed(scene, energySettings(256, 4096, 8, false), 32,
                [&](Renderer& renderer) { all.push_back(totalFlux(renderer.vpls())); });
    for (const uint32_t vpls : {1u, 7u, 100u}) {
        SCOPED_TRACE(vpls);
        std::vector<double> difference;
        forEachSeed(scene, energySettings(256, vpls, 8, false), 32, [&](Renderer& renderer) {
            EXPECT_EQ(renderer.status().vplsShaded, vpls);
            difference.push_back(totalFlux(renderer.vpls()) - all[difference.size()]);
        });
        expectMean(difference, 0.0, 0.5 * all[0]);
    }
}

TEST_F(VplEnergy, ManyMorePathsThanVpls) {
    // The paths come in several batches, and each must be heard, even if the list has one entry for all.
    Scene scene = closedBox(glm::vec3(0.5f));
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(1.0f)));
    for (const uint32_t vpls : {3u, 5u, 16u}) {
        const VplList list = renderVpls(scene, energySettings(12000, vpls, 1, false));
        EXPECT_EQ(list.status.vplsShaded, vpls);
        // Every vertex carries the same flux, so any sample of them has the exact sum.
        EXPECT_NEAR(totalFlux(list.vpls), 4.0 * kPi * 0.5, 1e-5) << vpls;
    }
    EXPECT_THROW(renderVpls(scene, energySettings(12000, 2, 1, false)), Error) << "a batch would have no entry";
}

TEST_F(VplEnergy, ASampleOfVeryManyVertices) {
    // 262,144 vertices for 20,000 entries: their product does not fit 32 bits.
    Scene scene = closedBox(glm::vec3(1.0f));
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(1.0f)));
    const VplList list = renderVpls(scene, energySettings(4096, 20000, 64, false));
    EXPECT_EQ(list.status.vplsTraced, 4096u * 64u);
    EXPECT_EQ(list.status.vplsShaded, 20000u);
    const std::vector<double> byBounce = fluxByBounce(list.vpls);
    // One entry of every stretch of 13.1 vertices, so 312 of each bounce, and sqrt(312) more or less: 5 of those are 28 %.
    for (size_t k = 0; k < 64; ++k) EXPECT_NEAR(byBounce[k], 4.0 * kPi, 4.0 * kPi * 0.28) << k + 1;
    std::vector<uint32_t> paths;
    for (const shared::LightData& vpl : list.vpls) paths.push_back(vpl.pathIndex);
    EXPECT_EQ(paths.back(), 4095u) << "the end of the list is sampled too";
    EXPECT_TRUE(std::is_sorted(paths.begin(), paths.end()));
}

TEST_F(VplEnergy, ASampleDoesNotResonateWithPathsOfOneLength) {
    // 256 paths of 8 vertices each for 64 entries: 32 vertices apart, entries at equal distances would have one depth.
    Scene scene = closedBox(glm::vec3(0.5f));
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(1.0f)));
    std::set<uint32_t> depths;
    for (const shared::LightData& vpl : renderVpls(scene, energySettings(256, 64, 8, false)).vpls) depths.insert(vpl.depth);
    EXPECT_EQ(depths.size(), 8u);
}

}  // namespace
}  // namespace manylight::test
