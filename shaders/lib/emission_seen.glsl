// What the camera sees of the lights themselves.
#ifndef MANYLIGHT_EMISSION_SEEN_GLSL
#define MANYLIGHT_EMISSION_SEEN_GLSL
#include "shaders/lib/camera.glsl"
#include "shaders/lib/environment.glsl"

// Unlit materials are seen as they are; others show what their front side emits.
vec3 emissionSeenAt(TriangleRecord t, vec2 barycentrics, vec3 toViewer) {
    const uint material = triangleMaterials[t.place];
    const vec2 footprint = footprintOfPixel(t, barycentrics, -toViewer);
    if (kEmissionTextured && materials[material].isUnlit != 0u) return albedoAt(t.place, barycentrics, material, footprint);
    const bool isFront = dot(counterClockwiseNormal(t), toViewer) > 0.0;
    return isFront ? emittedRadianceAt(t.place, barycentrics, material, footprint) : vec3(0.0);
}

// Beyond the scene is the environment.
vec3 emissionSeenBy(ivec2 pixel, bool isSurface, uint triangle) {
    const vec3 direction = cameraDirection(pixel);
    if (!isSurface) return radianceOfEnvironment(normalize(direction));
    const TriangleRecord t = loadTriangle(triangle);
    vec2 barycentrics = vec2(0.0);
    if (kEmissionTextured) barycentrics = barycentricsOfPixel(t, frame.cameraPosition, direction);
    return emissionSeenAt(t, barycentrics, -direction);
}

#endif
