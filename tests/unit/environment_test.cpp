// Maps of environments: where a direction lies in them, and the sampler against its density. The shader's functions,
// compiled as C++.
#include "engine/scene/environment.h"

#include "shaders/shared/constants.h"
#include "shaders/shared/sobol.h"
#include "tests/support/significance.h"

#include <gtest/gtest.h>
#include <glm/integer.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace manylight::shared::environment_shader {
using glm::clamp;
using glm::floor;
using glm::ivec2;
using glm::mix;
using glm::uintBitsToFloat;
using glm::umulExtended;

struct Frame {
    uvec2 environmentSize{0};
    uint environmentCellSide = 1;
    float environmentTurn = 0.0f;
    vec3 environmentRadiance{0.0f};
};
Frame frame;

struct RadianceBuffer {
    std::vector<vec4> texels;
};
struct CellBuffer {
    std::vector<EnvironmentCell> cells;
};
vec4 imageLoad(const RadianceBuffer& buffer, int i) { return buffer.texels.at(static_cast<size_t>(i)); }
uvec4 imageLoad(const CellBuffer& buffer, int i) {
    const EnvironmentCell& cell = buffer.cells.at(static_cast<size_t>(i));
    return {glm::floatBitsToUint(cell.threshold), cell.alias, glm::floatBitsToUint(cell.density),
            glm::floatBitsToUint(cell.aliasDensity)};
}

#define layout(...)
#define readonly
#define uniform
#define imageBuffer RadianceBuffer
#define uimageBuffer CellBuffer
#include "shaders/lib/environment.glsl"
#undef layout
#undef readonly
#undef uniform
#undef imageBuffer
#undef uimageBuffer
}  // namespace manylight::shared::environment_shader

namespace manylight::test {
namespace {

namespace shader = shared::environment_shader;
using glm::vec2;
using glm::vec3;

constexpr double kPi = shared::kPi;

/// A dim sky over a black ground with a sun of one texel, brighter by 10^4.
Scene sunnySky(uint32_t width, uint32_t height) {
    Scene scene;
    scene.environment = EnvironmentMap{.name = "sunny", .radiance = Image(width, height, 3), .turn = 0.3f};
    Image& image = scene.environment->radiance;
    for (uint32_t y = 0; y < height / 2; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            image.at(x, y, 0) = 0.2f + 0.1f * static_cast<float>(x) / static_cast<float>(width);
            image.at(x, y, 1) = 0.3f;
            image.at(x, y, 2) = 0.5f + 0.4f * static_cast<float>(y) / static_cast<float>(height);
        }
    for (uint32_t c = 0; c < 3; ++c) image.at(width / 3, height / 4, c) = 3000.0f;
    return scene;
}

EnvironmentTable bindToShader(const Scene& scene) {
    const EnvironmentTable table = buildEnvironmentTable(scene);
    shader::frame = {table.size, table.cellSide, table.turn, vec3(0.0f)};
    shader::environmentTexels.texels = table.texels;
    shader::environmentCells.cells = table.cells;
    return table;
}

class Draws {
  public:
    shader::EnvironmentSample next() {
        return shader::sampleEnvironmentMap({bits_(random_), bits_(random_)}, {unit_(random_), unit_(random_)});
    }

  private:
    std::mt19937 random_{5};
    std::uniform_int_distribution<uint32_t> bits_;
    std::uniform_real_distribution<float> unit_{0.0f, std::nextafter(1.0f, 0.0f)};
};

/// Calls `use(direction, solid angle)` for a fine grid over the sphere, `n` by 2 n.
template <typename Use>
void overTheSphere(int n, const Use& use) {
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < 2 * n; ++j) {
            const double theta = kPi * (i + 0.5) / n;
            const double phi = kPi * (j + 0.5) / n;
            const glm::dvec3 direction(std::sin(theta) * std::cos(phi), std::cos(theta),
                                       std::sin(theta) * std::sin(phi));
            const double solidAngle = (std::cos(kPi * i / n) - std::cos(kPi * (i + 1) / n)) * kPi / n;
            use(vec3(direction), solidAngle);
        }
}

TEST(Environment, TheMiddleIsAheadTheTopIsUpAndTheRightIsRight) {
    const auto uv = [](vec3 direction, float turn = 0.0f) { return shared::environmentUv(direction, turn); };
    EXPECT_NEAR(uv({0, 1, 0}).y, 0.0f, 1e-6f);
    EXPECT_NEAR(uv({0, -1, 0}).y, 1.0f, 1e-6f);
    EXPECT_NEAR(uv({0, 0, -1}).x, 0.5f, 1e-6f);
    EXPECT_NEAR(uv({0, 0, -1}).y, 0.5f, 1e-6f);
    EXPECT_NEAR(uv({1, 0, 0}).x, 0.75f, 1e-6f);
    EXPECT_NEAR(uv({-1, 0, 0}).x, 0.25f, 1e-6f);
    // A quarter turn, counter-clockwise seen from above, takes what was ahead to the left.
    EXPECT_NEAR(uv({-1, 0, 0}, 0.25f).x, 0.5f, 1e-6f);
    EXPECT_NEAR(shared::environmentDirection({0.5f, 0.5f}, 0.25f).x, -1.0f, 1e-6f);
}

TEST(Environment, DirectionsAndPlacesAreEachOthersInverse) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.01f, 0.99f);
    for (int i = 0; i < 10000; ++i) {
        const vec2 uv(unit(random), unit(random));
        const float turn = unit(random);
        const vec2 back = shared::environmentUv(shared::environmentDirection(uv, turn), turn);
        EXPECT_NEAR(back.x, uv.x, 2e-6f / std::sin(shared::kPi * uv.y)) << uv.y;
        EXPECT_NEAR(back.y, uv.y, 1e-6f);
    }
}

TEST(Environment, AnglesAreExactToRounding) {
    for (int i = 0; i < 3600; ++i) {
        const double angle = kPi * (i + 0.5) / 1800.0 - kPi;
        const auto x = static_cast<float>(2.5 * std::cos(angle));
        const auto y = static_cast<float>(2.5 * std::sin(angle));
        EXPECT_NEAR(double{shared::angleOf(x, y)}, std::atan2(double{y}, double{x}), 5e-7);
    }
    EXPECT_EQ(shared::angleOf(0.0f, 0.0f), 0.0f);
}

TEST(Environment, DensityIntegratesToOneAndIntegralIsThatOfTheRadiance) {
    const EnvironmentTable table = bindToShader(sunnySky(32, 16));
    double density = 0.0;
    double radiance = 0.0;
    overTheSphere(512, [&](vec3 direction, double solidAngle) {
        density += double{shader::densityOfEnvironmentMap(direction)} * solidAngle;
        const vec3 seen = shader::radianceOfEnvironment(direction);
        radiance += (double{seen.x} + double{seen.y} + double{seen.z}) / 3.0 * solidAngle;
    });
    EXPECT_NEAR(density, 1.0, 1e-3);
    EXPECT_NEAR(radiance, table.integral, 5e-3 * table.integral);
    const Scene constant = [] {
        Scene scene = sunnySky(5, 3);
        std::ranges::fill(scene.environment->radiance.texels, 0.25f);
        Light sky;
        sky.type = LightType::Constant;
        sky.emission = vec3(0.75f);
        scene.lights = {sky, sky};
        return scene;
    }();
    EXPECT_NEAR(buildEnvironmentTable(constant).integral, 4.0 * kPi * 1.75, 1e-6);
}

/// Counts draws in bins of 12 x 8 of the sphere against the integral of the density.
void expectDrawsByDensity(const Scene& scene, int grid) {
    constexpr uint32_t kAround = 12;
    constexpr uint32_t kHeights = 8;
    constexpr int kDraws = 200000;
    bindToShader(scene);
    const auto bin = [](vec3 direction) {
        const double around = std::atan2(double{direction.z}, double{direction.x}) / (2.0 * kPi) + 0.5;
        const double height = std::acos(std::clamp(double{direction.y}, -1.0, 1.0)) / kPi;
        return std::min(static_cast<uint32_t>(height * kHeights), kHeights - 1) * kAround +
               std::min(static_cast<uint32_t>(around * kAround), kAround - 1);
    };
    std::vector<double> expected(kAround * kHeights);
    std::vector<double> counts(kAround * kHeights);
    overTheSphere(grid, [&](vec3 direction, double solidAngle) {
        expected[bin(direction)] += kDraws * solidAngle * double{shader::densityOfEnvironmentMap(direction)};
    });
    double integral = 0.0;
    Draws draws;
    for (int i = 0; i < kDraws; ++i) {
        const shader::EnvironmentSample drawn = draws.next();
        counts[bin(drawn.direction)] += 1.0;
        ASSERT_GT(drawn.density, 0.0f);
        integral += double{drawn.radiance.y / drawn.density} / kDraws;
    }
    EXPECT_GT(chiSquareTest(counts, expected), 0.001);
    double green = 0.0;
    overTheSphere(grid, [&](vec3 direction, double solidAngle) {
        green += double{shader::radianceOfEnvironment(direction).y} * solidAngle;
    });
    EXPECT_NEAR(integral, green, 0.01 * green);
    // The bins would tell a wrong sampler.
    std::rotate(counts.begin(), counts.begin() + 1, counts.end());
    EXPECT_LT(chiSquareTest(counts, expected), 1e-6);
}

TEST(Environment, DrawsFollowTheDensity) { expectDrawsByDensity(sunnySky(24, 16), 768); }

TEST(Environment, DrawsFollowTheDensityOfCellsOfSeveralTexels) {
    Scene scene = sunnySky(1201, 601);  // more texels than cells, and no multiple of a cell's side
    Image& image = scene.environment->radiance;
    for (uint32_t y = 100; y < 180; ++y)
        for (uint32_t x = 300; x < 500; ++x) image.at(x, y, 1) = 30.0f;
    EXPECT_EQ(buildEnvironmentTable(scene).cellSide, 2u);
    expectDrawsByDensity(scene, 1024);
}

TEST(Environment, ASampleIsWhatALookUpInItsDirectionSays) {
    bindToShader(sunnySky(24, 16));
    Draws draws;
    int alike = 0;
    constexpr int kDraws = 2000;
    for (int i = 0; i < kDraws; ++i) {
        const shader::EnvironmentSample drawn = draws.next();
        EXPECT_NEAR(glm::length(drawn.direction), 1.0f, 1e-6f);
        const float density = shader::densityOfEnvironmentMap(drawn.direction);
        const vec3 radiance = shader::radianceOfEnvironment(drawn.direction);
        const bool isAlike = std::abs(density - drawn.density) < 1e-4f * density &&
                             std::abs(radiance.y - drawn.radiance.y) < 1e-3f * radiance.y;
        alike += isAlike ? 1 : 0;
    }
    EXPECT_GE(alike, kDraws - 3);  // a direction at the edge of a cell may be rounded into the next
}

TEST(Environment, WhatShinesAtAllCanBeDrawn) {
    Scene scene = sunnySky(16, 8);
    std::ranges::fill(scene.environment->radiance.texels, 0.0f);
    scene.environment->radiance.at(0, 3, 2) = 1.0f;  // its light reaches round the seam
    bindToShader(scene);
    int lit = 0;
    overTheSphere(256, [&](vec3 direction, double) {
        if (shader::radianceOfEnvironment(direction).z == 0.0f) return;
        ++lit;
        EXPECT_GT(shader::densityOfEnvironmentMap(direction), 0.0f);
    });
    EXPECT_GT(lit, 2000);  // four texels of 32 x 32
}

}  // namespace
}  // namespace manylight::test
