// Points and warps, as the shaders compute them: shaders/shared/sobol.h and warps.h compiled as C++.
#include "shaders/shared/sobol.h"
#include "shaders/shared/warps.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace manylight::shared {
namespace {

/// Every elementary interval of area 1/count holds exactly one of the first `count` points: a (0, m, 2)-net in base 2.
bool isNet(uint32_t log2Count, uint32_t seed, uint32_t firstIndex) {
    const uint32_t count = 1u << log2Count;
    for (uint32_t xBits = 0; xBits <= log2Count; ++xBits) {
        std::set<uint32_t> cells;
        for (uint32_t i = 0; i < count; ++i) {
            const glm::vec2 p = owenScrambledSobol2d(firstIndex + i, seed);
            const auto x = static_cast<uint32_t>(p.x * static_cast<float>(1u << xBits));
            const auto y = static_cast<uint32_t>(p.y * static_cast<float>(1u << (log2Count - xBits)));
            cells.insert(x << (log2Count - xBits) | y);
        }
        if (cells.size() != count) return false;
    }
    return true;
}

TEST(Sobol, EveryAlignedBlockOfPointsIsANet) {
    for (const uint32_t seed : {0u, 1u, 12345u})
        for (const uint32_t first : {0u, 256u, 1u << 20}) EXPECT_TRUE(isNet(8, seed, first)) << seed << " " << first;
}

TEST(Sobol, SecondDimensionIsPascalsTriangle) {
    EXPECT_EQ(sobolSecondDimension(0), 0u);
    EXPECT_EQ(sobolSecondDimension(1), 0x80000000u);  // 1/2
    EXPECT_EQ(sobolSecondDimension(2), 0xc0000000u);  // 3/4
    EXPECT_EQ(sobolSecondDimension(3), 0x40000000u);  // 1/4
}

TEST(Sobol, PointsLieInTheHalfOpenSquare) {
    for (uint32_t i = 0; i < 100000; ++i) {
        const glm::vec2 p = owenScrambledSobol2d(i * 2654435761u, i);
        ASSERT_TRUE(p.x >= 0.0f && p.x < 1.0f && p.y >= 0.0f && p.y < 1.0f) << i;
    }
    EXPECT_LT(unitFloat(0xffffffffu), 1.0f);
}

/// Mean of f over `count` warped points.
template <typename Function>
double meanOver(uint32_t count, Function f) {
    double sum = 0.0;
    for (uint32_t i = 0; i < count; ++i) sum += double{f(owenScrambledSobol2d(i, 7))};
    return sum / count;
}

TEST(Warps, CosineHemisphereHasTheMomentsOfCosOverPi) {
    // E[z] = 2/3, E[z^2] = 1/2 for density cos/pi; a 2^14-point net is this close.
    EXPECT_NEAR(meanOver(1 << 14, [](glm::vec2 u) { return squareToCosineHemisphere(u).z; }), 2.0 / 3.0, 1e-4);
    EXPECT_NEAR(meanOver(1 << 14,
                         [](glm::vec2 u) {
                             const float z = squareToCosineHemisphere(u).z;
                             return z * z;
                         }),
                0.5, 1e-4);
}

TEST(Warps, ConeIsUniformInSolidAngle) {
    for (const float cosCone : {-1.0f, 0.0f, 0.9f})
        EXPECT_NEAR(meanOver(1 << 14, [&](glm::vec2 u) { return squareToCone(u, cosCone).z; }), (1.0 + cosCone) / 2.0,
                    1e-4);
}

TEST(Warps, TriangleIsUniform) {
    EXPECT_NEAR(meanOver(1 << 14, [](glm::vec2 u) { return squareToTriangle(u).x; }), 1.0 / 3.0, 1e-4);
    EXPECT_NEAR(meanOver(1 << 14, [](glm::vec2 u) { return squareToTriangle(u).y; }), 1.0 / 3.0, 1e-4);
    EXPECT_NEAR(meanOver(1 << 14,
                         [](glm::vec2 u) {
                             const glm::vec2 b = squareToTriangle(u);
                             return b.x * b.y;
                         }),
                1.0 / 12.0, 1e-4);
}

TEST(Warps, BasisIsOrthonormalForEveryNormal) {
    for (uint32_t i = 0; i < 2000; ++i) {
        const glm::vec3 n = glm::normalize(squareToCone(owenScrambledSobol2d(i, 3), -1.0f));
        const glm::vec3 t = basisTangent(n);
        const glm::vec3 b = basisBitangent(n);
        EXPECT_NEAR(glm::dot(t, n), 0.0f, 2e-6f);
        EXPECT_NEAR(glm::dot(b, n), 0.0f, 2e-6f);
        EXPECT_NEAR(glm::length(t), 1.0f, 2e-6f);
        EXPECT_NEAR(glm::dot(glm::cross(t, b), n), 1.0f, 4e-6f);
    }
    EXPECT_NEAR(glm::length(toWorld({0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, -1.0f}) - glm::vec3(0, 0, -1)), 0.0f, 1e-6f);
}

}  // namespace
}  // namespace manylight::shared
