// What the camera sees of the lights themselves.
#ifndef MANYLIGHT_EMISSION_SEEN_GLSL
#define MANYLIGHT_EMISSION_SEEN_GLSL
#include "shaders/lib/surface.glsl"

// Emitters show on their front side only; beyond the scene is the environment.
vec3 radianceEmittedTowards(bool isSurface, uint triangle, vec3 toViewer) {
    if (!isSurface) return frame.environmentRadiance;
    const bool isFront = dot(counterClockwiseNormal(loadTriangle(triangle)), toViewer) > 0.0;
    return isFront ? materials[triangleMaterials[triangle]].emittedRadiance : vec3(0.0);
}

#endif
