// The gather with a shadow ray for every pixel and VPL that could see each other.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/gbuffer_read.glsl"
#include "shaders/lib/vpl_list_shuffle.glsl"
#include "shaders/lib/tile.glsl"

const uint kReceivers = 1u;
#include "shaders/lib/shade_vpls.glsl"

layout(constant_id = 12) const bool kAddToRadiance = false;

layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { ShadePush push; };

void main() {
    // No early return: every lane holds a VPL for the others.
    const ivec2 tile = ivec2(gl_WorkGroupID.xy * tileSize());
    const ivec2 pixel = tile + pixelInTile(gl_LocalInvocationIndex) + ivec2(0, push.firstRow);
    Receiver receivers[kReceivers] = {readGBuffer(pixel, true).receiver};
    vec3 sums[kReceivers] = {vec3(0.0)};
    shadeVpls(receivers, push.firstVpl, push.vplCount, frame.geometryBound, sums);
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);

    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    vec3 radiance = radianceFromSum(receivers[0], sums[0]);
    if (kAddToRadiance) radiance += imageLoad(radianceImage, pixel).rgb;
    imageStore(radianceImage, pixel, vec4(radiance, 1.0));
}
