// Directions and the equirectangular map of an environment. Both languages compile it.
#ifndef MANYLIGHT_SHARED_ENVIRONMENT_H
#define MANYLIGHT_SHARED_ENVIRONMENT_H
#include "shaders/shared/constants.h"
#ifdef __cplusplus
#include <cmath>
#endif

MANYLIGHT_SHARED_BEGIN
#ifdef __cplusplus
using glm::abs;
using glm::cos;
using glm::fract;
using glm::max;
using glm::min;
using glm::sin;
using glm::sqrt;
#endif

// A block of texels among which a direction is drawn evenly in uv, and its slot of the alias table.
struct EnvironmentCell {
    float threshold;     // below it the slot is this cell, above it the alias
    uint alias;
    float density;       // of this cell, 1/sr, times the sine of the angle to +Y
    float aliasDensity;  // the same of the alias
};

// The angle of (x, y) in [-pi, pi], to 1e-7 (Abramowitz and Stegun 1964, 4.4.49): devices' own may be off by 1e-3.
MANYLIGHT_FUNCTION float angleOf(float x, float y) {
    const float ratio = min(abs(x), abs(y)) / max(max(abs(x), abs(y)), 1e-30f);
    const float s = ratio * ratio;
    float p = 0.0028662257f;
    p = p * s - 0.0161657367f;
    p = p * s + 0.0429096138f;
    p = p * s - 0.0752896400f;
    p = p * s + 0.1065626393f;
    p = p * s - 0.1420889944f;
    p = p * s + 0.1999355085f;
    p = p * s - 0.3333314528f;
    float angle = ratio + ratio * s * p;
    if (abs(y) > abs(x)) angle = 0.5f * kPi - angle;
    if (x < 0.0f) angle = kPi - angle;
    return y < 0.0f ? -angle : angle;
}

// Sine of the angle to +Y, of a unit vector.
MANYLIGHT_FUNCTION float sineToPole(vec3 direction) {
    return sqrt(direction.x * direction.x + direction.z * direction.z);
}

// Place in the map, both in [0, 1]: v from +Y down to -Y; u = 1/2 at -Z and 3/4 at +X where `turn` is zero.
MANYLIGHT_FUNCTION vec2 environmentUv(vec3 direction, float turn) {
    const float u = 0.5f + angleOf(-direction.z, direction.x) / (2.0f * kPi) + turn;
    return vec2(fract(u), angleOf(direction.y, sineToPole(direction)) / kPi);
}

// The unit direction that environmentUv() takes there.
MANYLIGHT_FUNCTION vec3 environmentDirection(vec2 uv, float turn) {
    const float phi = 2.0f * kPi * (fract(uv.x - turn) - 0.5f);
    const float theta = kPi * uv.y;
    return vec3(sin(theta) * sin(phi), cos(theta), -sin(theta) * cos(phi));
}

#ifdef __cplusplus
static_assert(sizeof(EnvironmentCell) == 16);
#endif

MANYLIGHT_SHARED_END
#endif
