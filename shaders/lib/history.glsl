// What the next view has to know of a pixel, 16 bytes: depth along the axis, normal, what its light is divided by, and a
// word with its material and how far one frame's brightness scatters about the mean, relative to it.
#ifndef MANYLIGHT_HISTORY_GLSL
#define MANYLIGHT_HISTORY_GLSL
#include "shaders/lib/reconstruct.glsl"
#include "shaders/shared/packing.h"
#include "shaders/shared/temporal.h"

const float kDemodulatorSteps = 1023.0;
const float kWidestScatter = 6e4;  // half floats end there

// At least one step: it divides.
uint packDemodulator(vec3 factor) {
    const uvec3 steps = uvec3(clamp(factor * kDemodulatorSteps + 0.5, 1.0, kDemodulatorSteps));
    return steps.x | (steps.y << 10) | (steps.z << 20);
}

vec3 unpackDemodulator(uint bits) {
    return vec3(bits & 1023u, (bits >> 10) & 1023u, (bits >> 20) & 1023u) / kDemodulatorSteps;
}

uint packScatter(uint material, float scatter) {
    return (material & 0xffffu) | (packHalf2x16(vec2(min(scatter, kWidestScatter), 0.0)) << 16);
}

float unpackScatter(uint bits) { return unpackHalf2x16(bits >> 16).x; }

bool isSameMaterial(uint bits, uint otherBits) { return ((bits ^ otherBits) & 0xffffu) == 0u; }

bool hasSurface(uvec4 guide) { return guide.y != kNoNormal; }

// Nothing but sky, and reflections too sharp to stay where their surface is, have no history.
uvec4 historyGuide(GBufferPixel seen, float scatter) {
    const Receiver receiver = seen.receiver;
    if (!seen.isSurface || (kGlossy && receiver.bsdf.alpha < kRoughestLeftAlone)) return uvec4(0u, kNoNormal, 0u, 0u);
    const float depth = dot(receiver.position - frame.cameraPosition, frame.cameraForward);
    return uvec4(floatBitsToUint(depth), packUnitVector(receiver.normal), packDemodulator(demodulator(receiver)),
                 packScatter(triangleMaterials[placeOf(seen.triangle)], scatter));
}

// What earlier views knew of a pixel.
struct History {
    vec3 radiance;
    float frames;   // 0: nothing
    float scatter;  // of one frame's brightness, relative
};

uvec4 packHistory(History history) {
    return uvec4(floatBitsToUint(history.radiance), packHalf2x16(vec2(history.frames, history.scatter)));
}

History unpackHistory(uvec4 bits) {
    const vec2 counts = unpackHalf2x16(bits.w);
    return History(uintBitsToFloat(bits.xyz), counts.x, counts.y);
}

#endif
