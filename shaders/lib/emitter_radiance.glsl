// What an emissive triangle emits, point by point.
#ifndef MANYLIGHT_EMITTER_RADIANCE_GLSL
#define MANYLIGHT_EMITTER_RADIANCE_GLSL
#include "shaders/lib/emitters.glsl"
#include "shaders/lib/environment.glsl"
#include "shaders/lib/surface.glsl"

// Radiance that leaves pointOnTriangle(emitter, u).
vec3 radianceOfTriangle(Emitter emitter, vec2 u) {
    if (!kEmissionTextured || emitter.emissionTexture == kNoTexture) return emitter.emission;
    const uint place = placeOf(emitter.triangle);
    return emitter.emission *
           sampleTexture(emitter.emissionTexture, uvsAt(place, squareToTriangle(u)), kNoFootprint).rgb;
}

#endif
