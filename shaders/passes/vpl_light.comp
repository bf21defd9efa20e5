// The gather without visibility: several pixels an invocation, so that each VPL fetched serves them all.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/gbuffer_read.glsl"
#include "shaders/lib/vpl_list_shuffle.glsl"
#include "shaders/lib/tile.glsl"

layout(constant_id = 13) const uint kReceivers = 4u;  // pixels per invocation, one above the other
#include "shaders/lib/shade_vpls.glsl"

layout(constant_id = 12) const bool kAddToRadiance = false;

layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;
layout(push_constant, scalar) uniform Push { ShadePush push; };

void main() {
    // No early return: every lane holds a VPL for the others.
    const uint tileRows = tileSize().y;
    const ivec2 tile = ivec2(gl_WorkGroupID.xy * tileSize()) * ivec2(1, kReceivers);
    const ivec2 first = tile + pixelInTile(gl_LocalInvocationIndex) + ivec2(0, push.firstRow);
    Receiver receivers[kReceivers];
    vec3 sums[kReceivers];
    for (uint r = 0u; r < kReceivers; ++r) {
        receivers[r] = readGBuffer(first + ivec2(0, r * tileRows), false).receiver;
        sums[r] = vec3(0.0);
    }
    shadeVpls(receivers, push.firstVpl, push.vplCount, frame.geometryBound, sums);
    for (uint r = 0u; r < kReceivers; ++r) {
        const ivec2 pixel = first + ivec2(0, r * tileRows);
        if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) continue;
        vec3 radiance = radianceFromSum(receivers[r], sums[r]);
        if (kAddToRadiance) radiance += imageLoad(radianceImage, pixel).rgb;
        imageStore(radianceImage, pixel, vec4(radiance, 1.0));
    }
}
