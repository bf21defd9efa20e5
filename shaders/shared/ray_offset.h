// A point on a surface is moved off it, by more than its own error, so that rays from it do not meet that surface again.
#ifndef MANYLIGHT_SHARED_RAY_OFFSET_H
#define MANYLIGHT_SHARED_RAY_OFFSET_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// In the normalised frame a hit lies within gamma(7) (|b0 p0| + |b1 p1| + |b2 p2|) <= 4.2e-7 of its triangle along each
// axis (Pharr, Jakob and Humphreys, 6.8), wherever it is: the triangle's corners count, not the point. Nine times that.
MANYLIGHT_CONSTANT(float, kRayOffset, 1.0f / 262144.0f);

// `position` in the normalised frame (the step belongs to it), `side` a unit normal on the side to go to.
MANYLIGHT_FUNCTION vec3 offsetPoint(vec3 position, vec3 side) { return position + kRayOffset * side; }

MANYLIGHT_SHARED_END
#endif
