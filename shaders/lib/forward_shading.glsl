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

layout(constant_id = 15) const bool kCompensates = false;

layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { ShadePush push; };

vec4 forwardRadiance(uint triangle) {
    const ivec2 pixel = ivec2(gl_FragCoord.xy);
    const uint seed = pixelSeed(frame.seed, pixel);
    Receiver receivers[kReceivers] = {receiverOf(surfaceOfPixel(triangle, pixel), -normalize(cameraDirection(pixel)))};
    vec3 sums[kReceivers] = {sumOfLights(receivers[0], seed, push.firstLight, push.lightCount)};
    firstGloss = push.firstGloss;
    shadeVpls(receivers, push.firstVpl, push.vplCount, frame.geometryBound, sums);
    vec3 radiance = radianceFromSum(receivers[0], sums[0]);
    if (kGlossy && push.showEmission != 0u) radiance += reflectedLights(receivers[0], seed);
    if (kCompensates) radiance += compensation(receivers[0], seed);
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);
    if (push.showEmission != 0u) radiance += emissionSeenBy(pixel, true, triangle);
    return vec4(radiance, 1.0);
}

#endif
