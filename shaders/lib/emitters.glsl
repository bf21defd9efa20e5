// Sampling of emitters: which one, and where a light path starts.
#ifndef MANYLIGHT_EMITTERS_GLSL
#define MANYLIGHT_EMITTERS_GLSL
#include "shaders/lib/random.glsl"
#include "shaders/lib/spot.glsl"
#include "shaders/shared/lights.h"
#include "shaders/shared/warps.h"

layout(set = 0, binding = kBindingEmitters, scalar) readonly buffer EmitterBlock { Emitter emitters[]; };

// First entry whose cumulative probability exceeds u; `byArea` selects the table of area lights and environment.
uint chooseEmitter(float u, bool byArea) {
    uint low = 0u;
    uint high = frame.emitterCount - 1u;
    while (low < high) {
        const uint middle = (low + high) / 2u;
        const float cumulative = byArea ? emitters[middle].areaCumulative : emitters[middle].cumulative;
        if (cumulative > u) high = middle;
        else low = middle + 1u;
    }
    return low;
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
