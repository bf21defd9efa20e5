// Every sampler against the density it states, by chi-square over bins. The input is random numbers and not Sobol'
// points: these are more even than chance, and the test assumes chance.
#include "engine/scene/emitters.h"
#include "shaders/shared/sobol.h"
#include "shaders/shared/warps.h"
#include "tests/support/significance.h"

#include <gtest/gtest.h>
#include <glm/integer.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <random>

// The shaders' choice of emitters, compiled as C++ around a table of the test's own.
namespace manylight::shared::as_shader {
using glm::acos;
using glm::clamp;
using glm::ivec2;
using glm::uintBitsToFloat;
using glm::umulExtended;
using glm::uvec3;

struct Frame {
    uint emitterCount = 0;
    float sceneRadius = 1.5f;
    vec3 sceneCenter{0.25f, 0.5f, -1.0f};
};
Frame frame;

struct TexelBuffer {
    std::vector<uvec4> texels;
};
uvec4 imageLoad(const TexelBuffer& buffer, int i) { return buffer.texels.at(static_cast<size_t>(i)); }

#define layout(...)
#define readonly
#define uniform
#define uimageBuffer TexelBuffer
#include "shaders/lib/emitters.glsl"
#undef layout
#undef readonly
#undef uniform
#undef uimageBuffer
}  // namespace manylight::shared::as_shader

namespace manylight::test {
namespace {

using namespace shared;

constexpr uint32_t kSamples = 200000;
constexpr double kSignificance = 0.0025;
constexpr size_t kChiSquareTests = 40;  // at least as many as below: together they are wrong with kSignificance
constexpr uint32_t kAround = 12;        // bins of an azimuth

class Random {
  public:
    glm::vec2 next() { return {unit_(random_), unit_(random_)}; }

  private:
    std::mt19937 random_{11};
    std::uniform_real_distribution<float> unit_{0.0f, std::nextafter(1.0f, 0.0f)};
};

uint32_t binOf(double value, double low, double high, uint32_t bins) {
    const double place = (value - low) / (high - low) * bins;
    return std::min(static_cast<uint32_t>(std::max(place, 0.0)), bins - 1);
}

uint32_t azimuthBin(double x, double y) { return binOf(std::atan2(y, x), -double{kPi}, double{kPi}, kAround); }

/// p-value of samples whose bin `draw` gives, where bin i has `probability(i)`.
double pValueOf(uint32_t bins, const std::function<double(uint32_t)>& probability,
                const std::function<uint32_t(glm::vec2)>& draw, uint32_t samples = kSamples) {
    Random random;
    std::vector<double> counts(bins);
    std::vector<double> expected(bins);
    for (uint32_t i = 0; i < samples; ++i) counts[draw(random.next())] += 1.0;
    for (uint32_t i = 0; i < bins; ++i) expected[i] = samples * probability(i);
    return chiSquareTest(counts, expected);
}

bool passes(double pValue) { return pValue > sidak(kSignificance, kChiSquareTests); }

/// 10 bins of the cosine of the angle to the axis, from `lowest` to 1, by those of the azimuth.
constexpr uint32_t kHeights = 10;
uint32_t directionBin(glm::vec3 direction, double lowest) {
    return binOf(double{direction.z}, lowest, 1.0, kHeights) * kAround +
           azimuthBin(double{direction.x}, double{direction.y});
}
double cosineProbability(uint32_t bin) {
    const double low = bin / kAround / double{kHeights};
    const double high = low + 1.0 / kHeights;
    return (high * high - low * low) / kAround;
}
double equalProbability(uint32_t) { return 1.0 / (kHeights * kAround); }

uint32_t diskBin(glm::vec2 point, double radius) {
    const glm::dvec2 p(point);
    return binOf(glm::dot(p, p) / (radius * radius), 0.0, 1.0, kHeights) * kAround + azimuthBin(p.x, p.y);
}

TEST(Samplers, Disk) {
    EXPECT_TRUE(passes(
        pValueOf(kHeights * kAround, equalProbability, [](glm::vec2 u) { return diskBin(squareToDisk(u), 1.0); })));
}

TEST(Samplers, CosineHemisphere) {
    EXPECT_TRUE(passes(pValueOf(kHeights * kAround, cosineProbability,
                                [](glm::vec2 u) { return directionBin(squareToCosineHemisphere(u), 0.0); })));
}

TEST(Samplers, ConeAndSphere) {
    for (const float cosCone : {-1.0f, -0.3f, 0.0f, 0.5f, 0.99f})
        EXPECT_TRUE(passes(pValueOf(kHeights * kAround, equalProbability, [&](glm::vec2 u) {
            return directionBin(squareToCone(u, cosCone), double{cosCone});
        }))) << cosCone;
}

TEST(Samplers, CosineHemisphereAboutAnyNormal) {
    for (const glm::vec3 axis : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(1, 0, 0), glm::vec3(-1, 2, -3),
                                 glm::vec3(1e-4f, -2e-4f, -1)}) {
        const glm::vec3 normal = glm::normalize(axis);
        // A basis of the test's own.
        const glm::vec3 other = std::abs(normal.x) > 0.7f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
        const glm::vec3 s = glm::normalize(glm::cross(other, normal));
        const glm::vec3 t = glm::cross(normal, s);
        EXPECT_TRUE(passes(pValueOf(kHeights * kAround, cosineProbability, [&](glm::vec2 u) {
            const glm::vec3 direction = toWorld(squareToCosineHemisphere(u), normal);
            return directionBin({glm::dot(direction, s), glm::dot(direction, t), glm::dot(direction, normal)}, 0.0);
        }))) << axis.x;
    }
}

/// Squares of the plane of the barycentrics: whole below the diagonal, halved on it, impossible beyond.
constexpr uint32_t kSquares = 10;
uint32_t barycentricBin(double b1, double b2) {
    return binOf(b1, 0.0, 1.0, kSquares) * kSquares + binOf(b2, 0.0, 1.0, kSquares);
}
double barycentricProbability(uint32_t bin) {
    const uint32_t sum = bin / kSquares + bin % kSquares;
    const double share = sum + 1 < kSquares ? 2.0 : sum + 1 == kSquares ? 1.0 : 0.0;
    return share / (kSquares * kSquares);
}

TEST(Samplers, Triangle) {
    EXPECT_TRUE(passes(pValueOf(kSquares * kSquares, barycentricProbability, [](glm::vec2 u) {
        const glm::vec2 b = squareToTriangle(u);
        return barycentricBin(double{b.x}, double{b.y});
    })));
}

TEST(Samplers, PointsOnAnEmissiveTriangle) {
    Emitter emitter{};
    emitter.position = {1, 2, 3};
    emitter.edge1 = {2, 0, 0};
    emitter.edge2 = {1, 4, 0};  // x = 1 + 2 b1 + b2, y = 2 + 4 b2
    EXPECT_TRUE(passes(pValueOf(kSquares * kSquares, barycentricProbability, [&](glm::vec2 u) {
        const glm::dvec3 point(as_shader::pointOnTriangle(emitter, u));
        const double b2 = (point.y - 2.0) / 4.0;
        return barycentricBin((point.x - 1.0 - b2) / 2.0, b2);
    })));
    EXPECT_EQ(as_shader::normalOfTriangle(emitter), glm::vec3(0, 0, 1));
}

TEST(Samplers, DiskAcrossTheScene) {
    const glm::vec3 direction = glm::normalize(glm::vec3(1, -2, 2));
    const glm::vec3 s = glm::normalize(glm::cross(glm::vec3(0, 1, 0), direction));
    const glm::vec3 t = glm::cross(direction, s);
    const double radius = double{as_shader::frame.sceneRadius};
    EXPECT_TRUE(passes(pValueOf(kHeights * kAround, equalProbability, [&](glm::vec2 u) {
        const glm::vec3 fromCenter = as_shader::pointOnSceneDisk(direction, u) - as_shader::frame.sceneCenter;
        EXPECT_NEAR(glm::dot(fromCenter, direction), -2.0 * radius, 1e-5);
        return diskBin({glm::dot(fromCenter, s), glm::dot(fromCenter, t)}, radius);
    })));
}

TEST(Samplers, WholeNumbers) {
    for (const uint32_t count : {2u, 7u, 100u})
        EXPECT_TRUE(passes(pValueOf(
            count, [&](uint32_t) { return 1.0 / count; },
            [&](glm::vec2 u) {
                return as_shader::sampleInteger(static_cast<uint32_t>(double{u.x} * 4294967296.0), count);
            })));
}

/// Lights and triangles whose powers differ by up to 10^10, some of no power at all.
Scene manyEmitters() {
    Scene scene;
    std::mt19937 random(2);
    std::uniform_real_distribution<float> exponent(-5.0f, 5.0f);
    for (uint32_t i = 0; i < 60; ++i) {
        Light light;
        light.type = i % 4 == 0 ? LightType::Constant : LightType::Point;
        light.emission = glm::vec3(i % 7 == 0 ? 0.0f : std::pow(10.0f, i < 20 ? exponent(random) : 0.1f));
        scene.lights.push_back(light);
    }
    scene.vertices = {{{0, 0, 0}, {}, {}}, {{1, 0, 0}, {}, {}}, {{0, 1, 0}, {}, {}}, {{0, 0.01f, 0}, {}, {}}};
    Material material;
    material.emittedRadiance = glm::vec3(100.0f);
    scene.materials = {material};
    scene.triangles = {{{0, 1, 2}, 0}, {{0, 1, 3}, 0}, {{0, 1, 2}, 0}};
    return scene;
}

TEST(Samplers, ChoiceOfEmitters) {
    const EmitterTable table = buildEmitterTable(manyEmitters(), 1.0f);
    as_shader::emitterChoices.texels.resize(table.choices.size());
    std::memcpy(as_shader::emitterChoices.texels.data(), table.choices.data(),
                table.choices.size() * sizeof(EmitterChoice));
    as_shader::frame.emitterCount = static_cast<uint32_t>(table.emitters.size());
    for (const bool byArea : {false, true}) {
        const auto probability = [&](uint32_t i) {
            return double{byArea ? table.emitters[i].areaProbability : table.emitters[i].probability};
        };
        // 24 bits of one number and 8 of the other.
        const auto choose = [&](glm::vec2 u) {
            return as_shader::chooseEmitter(
                (static_cast<uint32_t>(double{u.x} * 16777216.0) << 8) | static_cast<uint32_t>(u.y * 256.0f), byArea);
        };
        EXPECT_TRUE(passes(pValueOf(as_shader::frame.emitterCount, probability, choose))) << byArea;
        for (const uint32_t bits : {0u, 1u, 0x7fffffffu, 0xfffffffeu, 0xffffffffu})
            EXPECT_GT(probability(as_shader::chooseEmitter(bits, byArea)), 0.0);
    }
}

TEST(Samplers, AnEmitterIsReadAsItWasWritten) {
    Emitter written{};
    written.position = {1, 2, 3};
    written.kind = kEmitterTriangle;
    written.edge1 = {4, 5, 6};
    written.probability = 0.25f;
    written.edge2 = {7, 8, 9};
    written.areaProbability = 0.5f;
    written.emission = {10, 11, 12};
    written.area = 13;
    written.cosCutoff = -0.5f;
    written.cosBeam = 0.75f;
    written.inverseRange = 14;
    written.triangle = 15;
    written.emissionTexture = 16;
    as_shader::emitterTexels.texels.resize(2 * kTexelsPerEmitter);
    std::memcpy(as_shader::emitterTexels.texels.data() + kTexelsPerEmitter, &written, sizeof(written));
    const Emitter read = as_shader::loadEmitter(1);
    EXPECT_EQ(std::memcmp(&read, &written, offsetof(Emitter, unused)), 0);
    EXPECT_EQ(read.triangle, written.triangle);
    EXPECT_EQ(read.emissionTexture, written.emissionTexture);
}

// What a pixel or a light path draws is point `index` of a sequence that its seed scrambles: over seeds it is random.
TEST(Samplers, APointOfASequenceIsUniformOverSeeds) {
    constexpr uint32_t kSide = 16;
    const auto probability = [](uint32_t) { return 1.0 / (kSide * kSide); };
    const auto bin = [](float x, float y) {
        return binOf(double{x}, 0.0, 1.0, kSide) * kSide + binOf(double{y}, 0.0, 1.0, kSide);
    };
    for (const uint32_t index : {0u, 1u, 5u, 1000003u}) {
        uint32_t seed = 0;
        EXPECT_TRUE(passes(pValueOf(kSide * kSide, probability, [&](glm::vec2) {
            const glm::vec2 point = as_shader::sample2d(index, seed++, 3);
            return bin(point.x, point.y);
        }))) << index;
        // Two dimensions of one seed, and one dimension of neighbouring pixels.
        seed = 0;
        EXPECT_TRUE(passes(pValueOf(kSide * kSide, probability, [&](glm::vec2) {
            ++seed;
            return bin(as_shader::sample2d(index, seed, 3).x, as_shader::sample2d(index, seed, 4).x);
        }))) << index;
        seed = 0;
        EXPECT_TRUE(passes(pValueOf(kSide * kSide, probability, [&](glm::vec2) {
            const glm::ivec2 pixel(seed % 512, seed / 512);
            ++seed;
            const glm::ivec2 neighbour(pixel.x + 1, pixel.y);
            return bin(as_shader::sample2d(index, as_shader::pixelSeed(1, pixel), 0).y,
                       as_shader::sample2d(index, as_shader::pixelSeed(1, neighbour), 0).y);
        }))) << index;
    }
}

TEST(Samplers, WrongWarpsAreFound) {
    const auto rejected = [](double pValue) { return !passes(pValue); };
    EXPECT_TRUE(rejected(pValueOf(kHeights * kAround, cosineProbability,
                                  [](glm::vec2 u) { return directionBin(squareToCone(u, 0.0f), 0.0); })));
    EXPECT_TRUE(rejected(pValueOf(kHeights * kAround, equalProbability, [](glm::vec2 u) {
        return diskBin(u.x * glm::vec2(std::cos(6.2831853f * u.y), std::sin(6.2831853f * u.y)), 1.0);
    })));
    EXPECT_TRUE(rejected(pValueOf(kSquares * kSquares, barycentricProbability, [](glm::vec2 u) {
        return barycentricBin(double{u.x} * (1.0 - double{u.y}), double{u.x} * double{u.y});
    })));
    // Nothing below a cosine of 0.14, and 2 % too much above.
    EXPECT_TRUE(rejected(pValueOf(kHeights * kAround, cosineProbability, [](glm::vec2 u) {
        return directionBin(squareToCosineHemisphere({0.98f * u.x, u.y}), 0.0);
    })));
}

}  // namespace
}  // namespace manylight::test
