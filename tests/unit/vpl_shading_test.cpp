// The shader core of all lighting, compiled as C++: closed forms to float rounding.
#include "shaders/shared/bsdf.h"
#include "shaders/shared/constants.h"
#include "shaders/shared/lights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace manylight::shared {
namespace {
using glm::acos;
using glm::clamp;
using glm::dot;
using glm::inversesqrt;
using glm::max;
using glm::min;

#include "shaders/lib/vpl_shading.glsl"
}  // namespace
}  // namespace manylight::shared

namespace manylight {
namespace {

using shared::LightData;
using shared::Receiver;

constexpr float kNoBound = std::numeric_limits<float>::max();

class Directions {
  public:
    glm::vec3 next() {
        const glm::dvec3 v(normal_(random_), normal_(random_), normal_(random_));
        return glm::vec3(glm::normalize(v));
    }

  private:
    std::mt19937 random_{7};
    std::normal_distribution<double> normal_;
};

Receiver receiverAt(glm::vec3 position, glm::vec3 normal) { return {position, normal, normal, normal, {}}; }

/// A point of a sphere of that radius around the origin, seen from inside.
Receiver receiverOnSphere(glm::vec3 direction, float radius) { return receiverAt(radius * direction, -direction); }

LightData surfaceLight(glm::vec3 position, glm::vec3 normal, float intensity) {
    LightData light{};
    light.position = position;
    light.direction = normal;
    light.intensity = intensity;
    light.colour = glm::vec3(1.0f, 0.5f, 0.25f);
    light.kind = shared::kLightSurface;
    return light;
}

TEST(VplShading, GeometryTermInsideASphereIsConstant) {
    Directions directions;
    for (const float radius : {0.5f, 1.0f, 3.0f}) {
        for (int i = 0; i < 10000; ++i) {
            const glm::vec3 a = directions.next();
            const glm::vec3 b = directions.next();
            if (glm::distance(a, b) < 0.05f) continue;  // cancellation: the rounding of positions over their distance
            const float g = shared::geometryTerm(-a, -b, radius * b - radius * a);
            ASSERT_NEAR(g * 4.0f * radius * radius, 1.0f, 1e-5f) << glm::distance(a, b);
        }
    }
}

TEST(VplShading, AnyVplSetInASphereGivesTheExactIrradiance) {
    // Flux 1 in each of the sets, so the irradiance is 1 / (4 pi R^2) * pi / pi.
    Directions directions;
    constexpr float kRadius = 0.5f;
    const double expected = 1.0 / (4.0 * double{shared::kPi} * double{kRadius} * double{kRadius});
    for (const int count : {1, 2, 17, 500}) {
        for (int set = 0; set < 20; ++set) {
            const glm::vec3 seenFrom = directions.next();
            const Receiver receiver = receiverOnSphere(seenFrom, kRadius);
            glm::dvec3 irradiance(0.0);
            for (int i = 0; i < count; ++i) {
                glm::vec3 at = directions.next();
                while (glm::distance(at, seenFrom) < 0.05f) at = directions.next();
                const LightData vpl = surfaceLight(kRadius * at, -at, shared::kInvPi / static_cast<float>(count));
                irradiance += glm::dvec3(shared::irradianceOfVpl(receiver, vpl, kNoBound));
            }
            ASSERT_NEAR(irradiance.x / expected, 1.0, 1e-5) << count;
            ASSERT_NEAR(irradiance.y / expected, 0.5, 1e-5) << count;
            ASSERT_NEAR(irradiance.z / expected, 0.25, 1e-5) << count;
        }
    }
}

TEST(VplShading, LightOnTheReceiverItselfGivesZero) {
    const glm::vec3 at(0.3f, -0.2f, 0.7f);
    const glm::vec3 normal(0, 1, 0);
    const Receiver receiver = receiverAt(at, normal);
    EXPECT_EQ(shared::irradianceOfVpl(receiver, surfaceLight(at, normal, 5.0f), kNoBound), glm::vec3(0.0f));
    EXPECT_EQ(shared::irradianceOfVpl(receiver, surfaceLight(at, -normal, 5.0f), kNoBound), glm::vec3(0.0f));
    EXPECT_EQ(shared::irradianceOfLight(receiver, surfaceLight(at, -normal, 5.0f)), glm::vec3(0.0f));
    for (const uint32_t kind : {shared::kLightPoint, shared::kLightSpot}) {
        LightData light = surfaceLight(at, normal, 5.0f);
        light.kind = kind;
        light.cosCutoff = -1.0f;
        light.cosBeam = -1.0f;
        EXPECT_EQ(shared::irradianceOfLight(receiver, light), glm::vec3(0.0f));
    }
}

TEST(VplShading, ClosePairsStayFinite) {
    const glm::vec3 normal(0, 1, 0);
    const Receiver receiver = receiverAt(glm::vec3(0.0f), normal);
    for (int exponent = -1; exponent >= -60; --exponent) {
        const float d = std::ldexp(1.0f, exponent);
        const glm::vec3 e = shared::irradianceOfVpl(receiver, surfaceLight({0, d, 0}, -normal, 1e-3f), kNoBound);
        ASSERT_TRUE(std::isfinite(e.x)) << exponent;
        ASSERT_GE(e.x, 0.0f);
        if (exponent > -45) {
            ASSERT_NEAR(e.x * d * d / 1e-3f, 1.0f, 1e-5f) << exponent;
        }
    }
}

TEST(VplShading, BackSidesNeitherShineNorReceive) {
    const glm::vec3 up(0, 1, 0);
    const Receiver receiver = receiverAt(glm::vec3(0.0f), up);
    EXPECT_GT(shared::irradianceOfVpl(receiver, surfaceLight({0.1f, 1, 0}, -up, 1.0f), kNoBound).x, 0.0f);
    EXPECT_EQ(shared::irradianceOfVpl(receiver, surfaceLight({0.1f, 1, 0}, up, 1.0f), kNoBound).x, 0.0f);
    EXPECT_EQ(shared::irradianceOfVpl(receiver, surfaceLight({0.1f, -1, 0}, up, 1.0f), kNoBound).x, 0.0f);
}

TEST(VplShading, WhatTheBoundLeavesAndWhatItCutsOffMakeTheWhole) {
    const glm::vec3 up(0, 1, 0);
    const Receiver receiver = receiverAt(glm::vec3(0.0f), up);
    for (const float height : {0.01f, 0.5f, 3.0f}) {
        const LightData vpl = surfaceLight({0.2f, height, -0.1f}, -up, 1.5f);
        const glm::vec3 whole = shared::irradianceOfVpl(receiver, vpl, kNoBound);
        for (const float bound : {0.0f, 1e-2f, 1.0f, 1e9f}) {
            const glm::vec3 parts =
                shared::irradianceOfVpl(receiver, vpl, bound) + shared::irradianceCutOff(receiver, vpl, bound);
            ASSERT_NEAR(parts.x, whole.x, 1e-6f * whole.x);
        }
        EXPECT_EQ(shared::irradianceCutOff(receiver, vpl, kNoBound), glm::vec3(0.0f));
    }
}

TEST(VplShading, TheBoundCutsTheGeometryTermOfVplsOnly) {
    const glm::vec3 up(0, 1, 0);
    const Receiver receiver = receiverAt(glm::vec3(0.0f), up);
    const LightData near = surfaceLight({0, 0.1f, 0}, -up, 2.0f);  // G = 100
    EXPECT_NEAR(shared::irradianceOfVpl(receiver, near, 30.0f).x, 60.0f, 1e-4f);
    EXPECT_NEAR(shared::irradianceOfVpl(receiver, near, 1000.0f).x, 200.0f, 1e-2f);
    EXPECT_NEAR(shared::irradianceOfLight(receiver, near).x, 200.0f, 1e-2f);
}

TEST(VplShading, PointAndDirectionalLight) {
    const glm::vec3 up(0, 1, 0);
    const Receiver receiver = receiverAt(glm::vec3(0.0f), up);
    LightData light = surfaceLight({3, 4, 0}, {1, 0, 0}, 10.0f);
    light.kind = shared::kLightPoint;
    EXPECT_NEAR(shared::irradianceOfLight(receiver, light).x, 10.0f * 4.0f / 125.0f, 1e-6f);
    light.kind = shared::kLightDirectional;
    light.direction = {0.6f, -0.8f, 0};
    EXPECT_NEAR(shared::irradianceOfLight(receiver, light).x, 8.0f, 1e-6f);
    light.direction = {0.6f, 0.8f, 0};
    EXPECT_EQ(shared::irradianceOfLight(receiver, light).x, 0.0f);
}

TEST(VplShading, SpotFallsOffLinearlyInTheAngle) {
    const float cosBeam = std::cos(0.3f);
    const float cosCutoff = std::cos(0.7f);
    for (int i = 0; i <= 100; ++i) {
        const float angle = 0.01f * static_cast<float>(i);
        const float expected = std::min(1.0f, std::max(0.0f, (0.7f - angle) / 0.4f));
        EXPECT_NEAR(shared::spotFalloff(std::cos(angle), cosBeam, cosCutoff), expected, 1e-5f) << angle;
    }
    EXPECT_EQ(shared::spotFalloff(0.9f, 0.8f, 0.8f), 1.0f) << "a hard edge";
    EXPECT_EQ(shared::spotFalloff(0.7f, 0.8f, 0.8f), 0.0f) << "a hard edge";
}

}  // namespace
}  // namespace manylight
