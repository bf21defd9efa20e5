// A point on a surface is moved off it by a few steps of its own floating-point grid (Waechter and Binder 2019).
#ifndef MANYLIGHT_SHARED_RAY_OFFSET_H
#define MANYLIGHT_SHARED_RAY_OFFSET_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN
#ifdef __cplusplus
using glm::abs;
using glm::floatBitsToInt;
using glm::intBitsToFloat;
#endif

// Near zero the grid is too fine to say anything about the error of a point: there the step is absolute.
MANYLIGHT_FUNCTION float offsetCoordinate(float position, float normal) {
    const int steps = int(256.0f * normal);
    const float moved = intBitsToFloat(floatBitsToInt(position) + (position < 0.0f ? -steps : steps));
    return abs(position) < 1.0f / 32.0f ? position + normal / 65536.0f : moved;
}

// `position` in the normalised frame (the absolute step belongs to it), `side` a unit normal on the side to go to.
MANYLIGHT_FUNCTION vec3 offsetPoint(vec3 position, vec3 side) {
    return vec3(offsetCoordinate(position.x, side.x), offsetCoordinate(position.y, side.y),
                offsetCoordinate(position.z, side.z));
}

MANYLIGHT_SHARED_END
#endif
