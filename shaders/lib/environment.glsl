// What surrounds the scene: the same radiance everywhere, or a map of it.
#ifndef MANYLIGHT_ENVIRONMENT_GLSL
#define MANYLIGHT_ENVIRONMENT_GLSL
#include "shaders/shared/environment.h"
#include "shaders/shared/sobol.h"

layout(constant_id = 20) const bool kEnvironmentMapped = true;

layout(set = 0, binding = kBindingEnvironmentTexels, rgba32f) readonly uniform imageBuffer environmentTexels;
layout(set = 0, binding = kBindingEnvironmentCells, rgba32ui) readonly uniform uimageBuffer environmentCells;

// Rows are closed rings; beyond the poles the last row goes on.
vec3 environmentTexel(ivec2 texel) {
    const int width = int(frame.environmentSize.x);
    const int column = texel.x < 0 ? texel.x + width : (texel.x < width ? texel.x : texel.x - width);
    const int row = clamp(texel.y, 0, int(frame.environmentSize.y) - 1);
    return vec3(imageLoad(environmentTexels, row * width + column));
}

vec3 radianceOfMap(vec2 uv) {
    const vec2 position = uv * vec2(frame.environmentSize) - 0.5f;
    const ivec2 corner = ivec2(floor(position));
    const vec2 weight = position - floor(position);
    const vec3 top = mix(environmentTexel(corner), environmentTexel(corner + ivec2(1, 0)), weight.x);
    const vec3 bottom = mix(environmentTexel(corner + ivec2(0, 1)), environmentTexel(corner + ivec2(1, 1)), weight.x);
    return mix(top, bottom, weight.y);
}

// Radiance from a unit direction.
vec3 radianceOfEnvironment(vec3 direction) {
    if (!kEnvironmentMapped) return frame.environmentRadiance;
    return radianceOfMap(environmentUv(direction, frame.environmentTurn));
}

uvec2 cellsOfEnvironment() {
    return (frame.environmentSize + (frame.environmentCellSide - 1u)) / frame.environmentCellSide;
}

// Of sampleEnvironmentMap(), per solid angle.
float densityOfEnvironmentMap(vec3 direction) {
    const uvec2 cells = cellsOfEnvironment();
    const uvec2 texel = uvec2(environmentUv(direction, frame.environmentTurn) * vec2(frame.environmentSize));
    const uvec2 cell = min(texel / frame.environmentCellSide, cells - 1u);
    const uvec4 record = imageLoad(environmentCells, int(cell.y * cells.x + cell.x));
    return uintBitsToFloat(record.z) / max(sineToPole(direction), 1e-6f);
}

struct EnvironmentSample {
    vec3 direction;  // unit, to the environment
    vec3 radiance;
    float density;   // 1/sr
};

// A direction by radiance: a cell from an alias table (Walker 1977), and a place in it. `bits` and `inside` are
// independent uniform numbers.
EnvironmentSample sampleEnvironmentMap(uvec2 bits, vec2 inside) {
    const uvec2 cells = cellsOfEnvironment();
    uint slot, rest;
    umulExtended(bits.x, cells.x * cells.y, slot, rest);
    const uvec4 record = imageLoad(environmentCells, int(slot));
    const bool isOwn = unitFloat(bits.y) < uintBitsToFloat(record.x);
    const uint cell = isOwn ? slot : record.y;
    const uvec2 corner = uvec2(cell % cells.x, cell / cells.x) * frame.environmentCellSide;
    const vec2 extent = vec2(min(uvec2(frame.environmentCellSide), frame.environmentSize - corner));
    const vec2 uv = (vec2(corner) + inside * extent) / vec2(frame.environmentSize);
    EnvironmentSample result;
    result.direction = environmentDirection(uv, frame.environmentTurn);
    result.radiance = radianceOfMap(uv);
    result.density = uintBitsToFloat(isOwn ? record.z : record.w) / max(sineToPole(result.direction), 1e-6f);
    return result;
}

#endif
