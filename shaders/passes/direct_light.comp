// Emission and the light of the real lights, for every pixel of the G-buffer.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/gbuffer_read.glsl"
#include "shaders/lib/emission_seen.glsl"
#include "shaders/lib/shade_lights.glsl"
#include "shaders/lib/tile.glsl"

layout(constant_id = 12) const bool kAddToRadiance = false;

layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { ShadePush push; };

void main() {
    const ivec2 tile = ivec2(gl_WorkGroupID.xy * tileSize());
    const ivec2 pixel = tile + pixelInTile(gl_LocalInvocationIndex) + ivec2(0, push.firstRow);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const GBufferPixel seen = readGBuffer(pixel, true);
    const uint seed = pixelSeed(frame.seed, pixel);
    vec3 radiance = radianceFromSum(seen.receiver, sumOfLights(seen.receiver, seed, push.firstLight, push.lightCount));
    if (kGlossy && push.showEmission != 0u) radiance += reflectedLights(seen.receiver, seed);
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);

    if (push.showEmission != 0u) radiance += emissionSeenBy(pixel, seen.isSurface, seen.triangle);
    if (kAddToRadiance) radiance += imageLoad(radianceImage, pixel).rgb;
    imageStore(radianceImage, pixel, vec4(radiance, 1.0));
}
