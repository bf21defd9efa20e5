// The reflection of surfaces, compiled as C++: reciprocity, energy, and that samples come as their density says.
#include "shaders/shared/bsdf.h"
#include "engine/core/statistics.h"
#include "shaders/shared/sobol.h"
#include "tests/support/significance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace manylight::shared {
namespace {

constexpr vec3 kNormal{0.0f, 0.0f, 1.0f};

vec3 directionAt(double cosine, double phi = 0.3) {
    const double sine = std::sqrt(1.0 - cosine * cosine);
    return vec3(glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), cosine));
}

vec2 point(uint32_t i, uint32_t dimension) { return owenScrambledSobol2d(i, hashCombine(17u, dimension)); }

/// Share of the light from `outgoing` that is reflected, largest channel; by the samples of the BSDF itself.
double albedoOf(const Bsdf& bsdf, vec3 outgoing, uint32_t count) {
    double sum = 0.0;
    for (uint32_t i = 0; i < count; ++i) {
        const vec3 incoming = sampleBsdf(bsdf, kNormal, outgoing, point(i, 1).x, point(i, 0));
        const float density = bsdfDensity(bsdf, kNormal, incoming, outgoing);
        if (incoming.z <= 0.0f || density <= 0.0f) continue;
        sum += double{largestChannel(evaluateBsdf(bsdf, kNormal, incoming, outgoing))} * double{incoming.z} /
               double{density};
    }
    return sum / count;
}

const std::vector<float> kRoughnesses = {0.0f, 0.1f, 0.3f, 0.5f, 0.7f, 1.0f};

TEST(Bsdf, IsReciprocal) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.02, 0.98);
    for (int i = 0; i < 1000; ++i) {
        const Bsdf bsdf = metallicRoughness(vec3(0.8f, 0.3f, 0.1f), static_cast<float>(uniform(random)),
                                            static_cast<float>(uniform(random)), vec3(0.04f, 0.1f, 0.02f));
        const vec3 a = directionAt(uniform(random), 6.0 * uniform(random));
        const vec3 b = directionAt(uniform(random), 6.0 * uniform(random));
        const vec3 there = evaluateBsdf(bsdf, kNormal, a, b);
        const vec3 back = evaluateBsdf(bsdf, kNormal, b, a);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(there[c], back[c], 1e-4f * there[c]) << i;
    }
}

TEST(Bsdf, NeverReflectsMoreThanArrives) {
    // Schlick's term of a smooth surface stands in for the albedo of the rough one, which tops it by 0.0012 at most.
    constexpr double kSlack = 0.002;
    for (const float roughness : kRoughnesses)
        for (const float metallic : {0.0f, 0.5f, 1.0f})
            for (const float specular : {0.0f, 0.02f, 0.04f, 0.3f, 1.0f})
                for (const double cosine : {0.02, 0.1, 0.3, 0.6, 0.9, 1.0}) {
                    const Bsdf bsdf = metallicRoughness(vec3(1.0f), metallic, roughness, vec3(specular));
                    EXPECT_LT(albedoOf(bsdf, directionAt(cosine), 4096), 1.0 + kSlack)
                        << roughness << " " << metallic << " " << specular << " " << cosine;
                }
}

TEST(Bsdf, ASmoothWhiteMetalReflectsEverything) {
    const Bsdf mirror = metallicRoughness(vec3(1.0f), 1.0f, 0.0f, vec3(0.04f));
    for (const double cosine : {0.1, 0.5, 1.0}) EXPECT_NEAR(albedoOf(mirror, directionAt(cosine), 256), 1.0, 1e-3);
}

TEST(Bsdf, ALambertianIsTheCaseWithoutSpecularReflection) {
    const Bsdf bsdf = metallicRoughness(vec3(0.5f, 0.25f, 1.0f), 0.0f, 0.3f, vec3(0.0f));
    for (const double cosine : {0.01, 0.5, 1.0}) {
        const vec3 f = evaluateBsdf(bsdf, kNormal, directionAt(cosine), directionAt(0.3));
        EXPECT_EQ(f, kInvPi * vec3(0.5f, 0.25f, 1.0f));
        EXPECT_EQ(bsdfDensity(bsdf, kNormal, directionAt(cosine), directionAt(0.3)),
                  max(directionAt(cosine).z, 0.0f) * kInvPi);
    }
}

TEST(Bsdf, AHeadOnDielectricReflectsFourPercent) {
    const Bsdf glass = metallicRoughness(vec3(0.0f), 0.0f, 0.05f, vec3(0.04f));
    EXPECT_NEAR(albedoOf(glass, vec3(0.0f, 0.0f, 1.0f), 4096), 0.04, 1e-3);
}

struct Roughness {
    float metallic;
    float roughness;
    double cosine;
};

class BsdfSamples : public ::testing::TestWithParam<Roughness> {};

INSTANTIATE_TEST_SUITE_P(Lobes, BsdfSamples,
                         ::testing::Values(Roughness{1.0f, 0.3f, 0.9}, Roughness{1.0f, 0.6f, 0.3},
                                           Roughness{1.0f, 1.0f, 0.05}, Roughness{0.0f, 0.4f, 0.7},
                                           Roughness{0.0f, 0.2f, 0.15}, Roughness{0.5f, 0.5f, 0.5}));

TEST_P(BsdfSamples, ComeAsTheirDensitySays) {
    constexpr int kCosines = 12;
    constexpr int kAngles = 24;
    constexpr int kFine = 96;  // quadrature points a side of a bin
    constexpr uint32_t kSamples = 100000;
    const Bsdf bsdf = metallicRoughness(vec3(0.6f), GetParam().metallic, GetParam().roughness, vec3(0.04f));
    const vec3 outgoing = directionAt(GetParam().cosine);
    std::vector<double> counts(kCosines * kAngles + 1);
    std::mt19937 random(11);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const auto number = [&] { return std::min(uniform(random), 0.99999994f); };
    for (uint32_t i = 0; i < kSamples; ++i) {
        const float uLobe = number();
        const float u = number();
        const vec3 incoming = sampleBsdf(bsdf, kNormal, outgoing, uLobe, vec2(u, number()));
        const double phi = std::atan2(double{incoming.y}, double{incoming.x}) / (2.0 * double{kPi}) + 0.5;
        const int column = std::min(static_cast<int>(phi * kAngles), kAngles - 1);
        const int row = std::min(static_cast<int>(incoming.z * kCosines), kCosines - 1);
        counts[incoming.z <= 0.0f ? counts.size() - 1 : static_cast<size_t>(row * kAngles + column)] += 1.0;
    }
    std::vector<double> expected(counts.size());
    double above = 0.0;
    for (int row = 0; row < kCosines * kFine; ++row)
        for (int column = 0; column < kAngles * kFine; ++column) {
            const double z = (row + 0.5) / (kCosines * kFine);
            const double phi = ((column + 0.5) / (kAngles * kFine) - 0.5) * 2.0 * double{kPi};
            const double density = bsdfDensity(bsdf, kNormal, directionAt(z, phi), outgoing);
            const double share = density * 2.0 * double{kPi} / (kCosines * kFine * kAngles * kFine);
            expected[static_cast<size_t>(row / kFine * kAngles + column / kFine)] += share * kSamples;
            above += share;
        }
    EXPECT_LT(above, 1.0 + 1e-3);
    expected.back() = std::max(0.0, 1.0 - above) * kSamples;
    // Below the horizon the density is not asked for: only what is above is compared, and its sum.
    EXPECT_NEAR(counts.back(), expected.back(), 5.0 * std::sqrt(expected.back() + 1.0) + 1e-3 * kSamples);
    counts.pop_back();
    expected.pop_back();
    EXPECT_GT(test::chiSquareTest(counts, expected), 1e-4);
}

}  // namespace
}  // namespace manylight::shared
