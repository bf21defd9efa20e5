// Warps from the unit square, each with the density it produces.
#ifndef MANYLIGHT_SHARED_WARPS_H
#define MANYLIGHT_SHARED_WARPS_H
#include "shaders/shared/constants.h"
#ifdef __cplusplus
#include <glm/geometric.hpp>
#include <cmath>
#endif

MANYLIGHT_SHARED_BEGIN
#ifdef __cplusplus
using glm::abs;
using glm::cos;
using glm::max;
using glm::min;
using glm::sin;
using glm::sqrt;
#endif

// A right-handed basis around a unit vector n (Duff et al. 2017).
MANYLIGHT_FUNCTION vec3 basisTangent(vec3 n) {
    const float s = n.z < 0.0f ? -1.0f : 1.0f;
    const float a = -1.0f / (s + n.z);
    return vec3(1.0f + s * n.x * n.x * a, s * n.x * n.y * a, -s * n.x);
}
MANYLIGHT_FUNCTION vec3 basisBitangent(vec3 n) {
    const float s = n.z < 0.0f ? -1.0f : 1.0f;
    const float a = -1.0f / (s + n.z);
    return vec3(n.x * n.y * a, s + n.y * n.y * a, -n.y);
}
MANYLIGHT_FUNCTION vec3 toWorld(vec3 local, vec3 n) {
    return basisTangent(n) * local.x + basisBitangent(n) * local.y + n * local.z;
}

// Uniform on the unit disk, density 1/pi.
MANYLIGHT_FUNCTION vec2 squareToDisk(vec2 u) {
    const float r = sqrt(u.x);
    const float phi = 2.0f * kPi * u.y;
    return vec2(r * cos(phi), r * sin(phi));
}

// Cosine-weighted about +z, density cos/pi per solid angle.
MANYLIGHT_FUNCTION vec3 squareToCosineHemisphere(vec2 u) {
    const vec2 disk = squareToDisk(u);
    return vec3(disk.x, disk.y, sqrt(max(0.0f, 1.0f - u.x)));
}

// Uniform in the cone about +z with the given cosine, density 1 / (2 pi (1 - cosCone)); cosCone = -1 is the sphere.
MANYLIGHT_FUNCTION vec3 squareToCone(vec2 u, float cosCone) {
    const float z = 1.0f - u.x * (1.0f - cosCone);
    const float r = sqrt(max(0.0f, 1.0f - z * z));
    const float phi = 2.0f * kPi * u.y;
    return vec3(r * cos(phi), r * sin(phi), z);
}

// Barycentrics (b1, b2) uniform on a triangle, density 1/area.
MANYLIGHT_FUNCTION vec2 squareToTriangle(vec2 u) {
    const float r = sqrt(u.x);
    return vec2(r * (1.0f - u.y), r * u.y);
}

MANYLIGHT_SHARED_END
#endif
