// Unit vectors in 32 bits: the octahedral map (Meyer et al. 2010) with two 16-bit signed numbers.
#ifndef MANYLIGHT_SHARED_PACKING_H
#define MANYLIGHT_SHARED_PACKING_H
#include "shaders/shared/language.h"
#ifdef __cplusplus
#include <glm/packing.hpp>
#endif

MANYLIGHT_SHARED_BEGIN
#ifdef __cplusplus
using glm::abs;
using glm::normalize;
using glm::packSnorm2x16;
using glm::unpackSnorm2x16;
#endif

// In place of a packed normal: the corner has none, the triangle is flat. No unit vector packs to these bits, as
// packSnorm2x16 never makes -32768.
MANYLIGHT_CONSTANT(uint, kNoNormal, 0x80008000u);

MANYLIGHT_FUNCTION float signNotZero(float x) { return x < 0.0f ? -1.0f : 1.0f; }

// `direction` is a unit vector.
MANYLIGHT_FUNCTION uint packUnitVector(vec3 direction) {
    const float scale = 1.0f / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    vec2 square = vec2(direction.x * scale, direction.y * scale);
    if (direction.z < 0.0f) {
        square = vec2((1.0f - abs(square.y)) * signNotZero(square.x), (1.0f - abs(square.x)) * signNotZero(square.y));
    }
    return packSnorm2x16(square);
}

MANYLIGHT_FUNCTION vec3 unpackUnitVector(uint bits) {
    const vec2 square = unpackSnorm2x16(bits);
    const float z = 1.0f - abs(square.x) - abs(square.y);
    const float fold = z < 0.0f ? -z : 0.0f;
    return normalize(vec3(square.x - signNotZero(square.x) * fold, square.y - signNotZero(square.y) * fold, z));
}

MANYLIGHT_SHARED_END
#endif
