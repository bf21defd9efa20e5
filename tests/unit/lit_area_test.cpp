#include "engine/techniques/lit_area.h"
#include "shaders/shared/sobol.h"

#include <gtest/gtest.h>

#include <vector>

namespace manylight {
namespace {

/// `count` VPLs over a square of side `side`, one corner at `corner`.
void addSquare(std::vector<shared::LightData>& vpls, uint32_t count, float side, glm::vec3 corner) {
    for (uint32_t i = 0; i < count; ++i) {
        const glm::vec2 at =
            shared::owenScrambledSobol2d(i, shared::hashCombine(7u, static_cast<uint32_t>(vpls.size())));
        shared::LightData vpl{};
        vpl.position = corner + side * glm::vec3(at.x, 0.0f, at.y);
        vpl.intensity = 1.0f;
        vpls.push_back(vpl);
    }
}

constexpr double kScatter = 1.1;

}  // namespace

TEST(LitArea, OfASquareIsItsArea) {
    for (const float side : {1.0f, 0.125f, 12.0f}) {
        std::vector<shared::LightData> vpls;
        addSquare(vpls, 1024, side, {3.0f, 0.0f, 0.0f});
        const double area = litArea(vpls).value();
        EXPECT_GT(area, double{side * side} / kScatter);
        EXPECT_LT(area, double{side * side} * kScatter);
    }
}

TEST(LitArea, AGroundThatLittleLightMeetsDoesNotCount) {
    std::vector<shared::LightData> vpls;
    addSquare(vpls, 960, 1.0f, glm::vec3(0.0f));
    addSquare(vpls, 64, 100.0f, {10.0f, 0.0f, 0.0f});
    EXPECT_LT(litArea(vpls).value(), 1.4);
    EXPECT_GT(litArea(vpls).value(), 0.8);
}

TEST(LitArea, DarkVplsDoNotCount) {
    std::vector<shared::LightData> vpls;
    addSquare(vpls, 512, 1.0f, glm::vec3(0.0f));
    const std::optional<double> before = litArea(vpls);
    vpls.resize(1024);
    EXPECT_EQ(litArea(vpls), before);
}

TEST(LitArea, OfTooFewIsUnknown) {
    std::vector<shared::LightData> vpls;
    EXPECT_FALSE(litArea(vpls));
    addSquare(vpls, 32, 1.0f, glm::vec3(0.0f));
    EXPECT_FALSE(litArea(vpls));
    // All at one place have no area.
    EXPECT_FALSE(litArea(std::vector<shared::LightData>(1024, vpls.front())));
}

}  // namespace manylight
