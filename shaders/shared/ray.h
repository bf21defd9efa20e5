// Rays as they are stored: 32 bytes, two texels.
#ifndef MANYLIGHT_SHARED_RAY_H
#define MANYLIGHT_SHARED_RAY_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// A question to the BVH: what lies at t in (0, tMax) along origin + t * direction? `direction` need not be unit;
// a zero direction hits nothing.
struct RayQuery {
    vec3 origin;
    float tMax;
    vec3 direction;
    float unused;
};

MANYLIGHT_SHARED_END
#endif
