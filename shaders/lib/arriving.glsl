// What of a light's irradiance arrives: shadows.
#ifndef MANYLIGHT_ARRIVING_GLSL
#define MANYLIGHT_ARRIVING_GLSL
#include "shaders/lib/ray.glsl"
#include "shaders/lib/vpl_shading.glsl"

layout(constant_id = 10) const bool kCastShadows = true;

const float kBeyondTheScene = 8.0;

// The part of `irradiance` that arrives. Where nothing would, the ray is empty and ends at once.
vec3 arriving(vec3 irradiance, Receiver receiver, LightData light) {
    if (!kCastShadows) return irradiance;
    const bool parallel = light.kind == kLightDirectional;
    const vec3 toLight = parallel ? -kBeyondTheScene * light.direction : light.position - receiver.position;
    // A shading normal may face light that is behind the surface.
    const bool isBehind = dot(receiver.geometricNormal, toLight) <= 0.0;
    const bool matters = irradiance.x + irradiance.y + irradiance.z > 0.0 && !isBehind;
    const vec3 start = offsetPoint(receiver.position, receiver.geometricNormal);
    const vec3 end = light.kind == kLightSurface ? offsetRayOrigin(light.position, light.direction, -toLight)
                                                 : receiver.position + toLight;
    const bool blocked = occluded(start, matters ? end - start : vec3(0.0), 1.0);
    return blocked || isBehind ? vec3(0.0) : irradiance;
}

#endif
