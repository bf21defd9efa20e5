// Rays that leave surfaces.
#ifndef MANYLIGHT_LIB_RAY
#define MANYLIGHT_LIB_RAY
#include "shaders/lib/bvh.glsl"
#include "shaders/shared/ray_offset.h"

// `geometricNormal` is a unit normal on either side; the point moves to the side that `direction` leaves on.
vec3 offsetRayOrigin(vec3 position, vec3 geometricNormal, vec3 direction) {
    return offsetPoint(position, dot(geometricNormal, direction) < 0.0f ? -geometricNormal : geometricNormal);
}

// Do two surface points see each other? Both ends are moved off their surfaces, towards each other.
bool visible(vec3 a, vec3 normalA, vec3 b, vec3 normalB) {
    const vec3 start = offsetRayOrigin(a, normalA, b - a);
    const vec3 end = offsetRayOrigin(b, normalB, a - b);
    return !occluded(start, end - start, 1.0f);
}

#endif
