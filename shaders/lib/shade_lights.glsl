// The loops over lights. Deferred and forward shading call the same two functions and differ only in where their
// receivers come from; the including file says how many it has (kReceivers) and which VPL list it reads.
#ifndef MANYLIGHT_SHADE_LIGHTS_GLSL
#define MANYLIGHT_SHADE_LIGHTS_GLSL
#include "shaders/lib/ray.glsl"
#include "shaders/lib/vpl_shading.glsl"

layout(constant_id = 2) const bool kCastShadows = true;

layout(set = 0, binding = kBindingLights, scalar) readonly buffer LightBlock { LightData lights[]; };

const float kBeyondTheScene = 8.0;

// The part of `irradiance` that arrives. Where nothing would, the ray is empty and ends at once.
vec3 arriving(vec3 irradiance, Receiver receiver, LightData light) {
    if (!kCastShadows) return irradiance;
    const bool matters = irradiance.x + irradiance.y + irradiance.z > 0.0;
    const bool parallel = light.kind == kLightDirectional;
    const vec3 toLight = parallel ? -kBeyondTheScene * light.direction : light.position - receiver.position;
    const vec3 start = offsetRayOrigin(receiver.position, receiver.geometricNormal, toLight);
    const vec3 end = light.kind == kLightSurface ? offsetRayOrigin(light.position, light.direction, -toLight)
                                                 : receiver.position + toLight;
    const bool blocked = occluded(start, matters ? end - start : vec3(0.0), 1.0);
    return blocked ? vec3(0.0) : irradiance;
}

// Adds the irradiance of real lights [first, first + count).
void shadeLights(Receiver receivers[kReceivers], uint first, uint count, inout vec3 irradiance[kReceivers]) {
    for (uint i = first; i < first + count; ++i) {
        const LightData light = lights[i];
        for (uint r = 0u; r < kReceivers; ++r)
            irradiance[r] += arriving(irradianceOfLight(receivers[r], light), receivers[r], light);
    }
}

// Adds the irradiance of VPLs [first, first + count). Blocks are summed apart, which keeps rounding small in long lists.
void shadeVpls(Receiver receivers[kReceivers], uint first, uint count, float bound, inout vec3 irradiance[kReceivers]) {
    for (uint base = first; base < first + count; base += kVplBlock) {
        loadVplBlock(base);
        vec3 blockSum[kReceivers];
        for (uint r = 0u; r < kReceivers; ++r) blockSum[r] = vec3(0.0);
        for (uint i = 0u; i < kVplBlock; ++i) {
            const LightData vpl = vplOfBlock(i);
            for (uint r = 0u; r < kReceivers; ++r)
                blockSum[r] += arriving(irradianceOfVpl(receivers[r], vpl, bound), receivers[r], vpl);
        }
        for (uint r = 0u; r < kReceivers; ++r) irradiance[r] += blockSum[r];
    }
}

#endif
