// Sampling of emitters: which one, and where a light path starts.
#ifndef MANYLIGHT_EMITTERS_GLSL
#define MANYLIGHT_EMITTERS_GLSL
#include "shaders/lib/random.glsl"
#include "shaders/lib/spot.glsl"
#include "shaders/shared/lights.h"
#include "shaders/shared/warps.h"

layout(constant_id = 21) const bool kManyEmitters = true;  // more than one to choose from

layout(set = 0, binding = kBindingEmitters, rgba32ui) readonly uniform uimageBuffer emitterTexels;
layout(set = 0, binding = kBindingEmitterChoices, rgba32ui) readonly uniform uimageBuffer emitterChoices;

// Fields that the caller does not use cost no load.
Emitter loadEmitter(uint i) {
    const int first = int(i * kTexelsPerEmitter);
    const uvec4 position = imageLoad(emitterTexels, first);
    const uvec4 edge1 = imageLoad(emitterTexels, first + 1);
    const uvec4 edge2 = imageLoad(emitterTexels, first + 2);
    const uvec4 emission = imageLoad(emitterTexels, first + 3);
    const uvec4 delta = imageLoad(emitterTexels, first + 4);
    const uvec4 surface = imageLoad(emitterTexels, first + 5);
    Emitter emitter;
    emitter.position = uintBitsToFloat(uvec3(position));
    emitter.kind = position.w;
    emitter.edge1 = uintBitsToFloat(uvec3(edge1));
    emitter.probability = uintBitsToFloat(edge1.w);
    emitter.edge2 = uintBitsToFloat(uvec3(edge2));
    emitter.areaProbability = uintBitsToFloat(edge2.w);
    emitter.emission = uintBitsToFloat(uvec3(emission));
    emitter.area = uintBitsToFloat(emission.w);
    emitter.cosCutoff = uintBitsToFloat(delta.x);
    emitter.cosBeam = uintBitsToFloat(delta.y);
    emitter.inverseRange = uintBitsToFloat(delta.z);
    emitter.triangle = surface.x;
    emitter.emissionTexture = surface.y;
    return emitter;
}

// An emitter by its probability; `byArea` chooses among area lights and environment. What is left of `bits` below the
// number of the slot decides between the slot's two emitters.
uint chooseEmitter(uint bits, bool byArea) {
    if (!kManyEmitters) return 0u;
    uint slot, rest;
    umulExtended(bits, frame.emitterCount, slot, rest);
    const uvec4 choice = imageLoad(emitterChoices, int(slot));
    const float threshold = uintBitsToFloat(byArea ? choice.z : choice.x);
    return unitFloat(rest) < threshold ? slot : (byArea ? choice.w : choice.y);
}

vec3 pointOnTriangle(Emitter emitter, vec2 u) {
    const vec2 b = squareToTriangle(u);
    return emitter.position + b.x * emitter.edge1 + b.y * emitter.edge2;
}

vec3 normalOfTriangle(Emitter emitter) {
    const float scale = 1.0f / max(length(emitter.edge1), 1e-30f);
    return normalize(cross(emitter.edge1 * scale, emitter.edge2 / max(length(emitter.edge2), 1e-30f)));
}

// A start on the disk that faces `direction` and covers the whole scene.
vec3 pointOnSceneDisk(vec3 direction, vec2 u) {
    const vec2 disk = squareToDisk(u) * frame.sceneRadius;
    return frame.sceneCenter - 2.0f * frame.sceneRadius * direction + toWorld(vec3(disk, 0.0f), direction);
}

#endif
