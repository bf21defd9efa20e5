// What both forward entry points share: a fragment loops over the real lights and then over the VPLs.
#ifndef MANYLIGHT_FORWARD_SHADING_GLSL
#define MANYLIGHT_FORWARD_SHADING_GLSL
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/camera.glsl"
#include "shaders/lib/emission_seen.glsl"
#include "shaders/lib/vpl_list_uniform.glsl"

const uint kReceivers = 1u;
#include "shaders/lib/shade_lights.glsl"
#include "shaders/lib/shade_vpls.glsl"
#include "shaders/lib/compensation.glsl"

layout(constant_id = 7) const bool kCompensates = false;

layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { ShadePush push; };

vec4 forwardRadiance(uint triangle) {
    const ivec2 pixel = ivec2(gl_FragCoord.xy);
    const Surface surface = surfaceOfPixel(triangle, pixel);
    Receiver receivers[kReceivers] = {Receiver(surface.position, surface.normal, surface.geometricNormal)};
    vec3 irradiance[kReceivers] = {
        irradianceOfLights(receivers[0], pixelSeed(frame.seed, pixel), push.firstLight, push.lightCount)};
    shadeVpls(receivers, push.firstVpl, push.vplCount, frame.geometryBound, irradiance);
    vec3 radiance = surface.albedo * kInvPi * irradiance[0];
    if (kCompensates) radiance += compensation(receivers[0], surface.albedo, pixelSeed(frame.seed, pixel));
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);
    if (push.showEmission != 0u) radiance += radianceEmittedTowards(true, triangle, -cameraDirection(pixel));
    return vec4(radiance, 1.0);
}

#endif
