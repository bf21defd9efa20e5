// Emission and the light of the real lights, for every pixel of the G-buffer. Where a filter follows, what samples of area
// lights say is kept apart for it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/gbuffer_read.glsl"
#include "shaders/lib/emission_seen.glsl"
#include "shaders/lib/shade_lights.glsl"
#include "shaders/lib/reconstruct.glsl"
#include "shaders/lib/tile.glsl"

layout(constant_id = 12) const bool kAddToRadiance = false;
layout(constant_id = 40) const bool kAreasApart = false;
layout(constant_id = 41) const bool kAddToAreas = false;

layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;
layout(set = 0, binding = kBindingReconstructed, rgba32f) uniform image2D areaLight;
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { ShadePush push; };

// Demodulated light of the samples [first, end), and its standard error by their scatter; of one sample, itself.
vec4 lightOfAreas(Receiver receiver, uint seed, uint first, uint end) {
    vec3 sum = vec3(0.0);
    float scale = 0.0;  // over the first light that is met: squares of very faint light would underflow
    vec2 moments = vec2(0.0);
    for (uint s = first; s < end; ++s) {
        const vec3 light = demodulated(receiver, summandOfArea(receiver, s, seed));
        const float level = brightness(light);
        if (scale == 0.0 && level > 0.0) scale = 1.0 / level;
        sum += light;
        moments += vec2(scale * level, scale * level * scale * level);
    }
    const float count = max(float(end - first), 1.0);
    const float scatter = max(moments.y - moments.x * moments.x / count, 0.0) * count / max(count - 1.0, 1.0);
    const float squaredError = count > 1.0 ? scatter : moments.y;
    return vec4(sum, scale > 0.0 ? sqrt(squaredError) / scale : 0.0);
}

void storeLightOfAreas(ivec2 pixel, Receiver receiver, uint seed) {
    const uint deltas = frame.deltaLightCount;
    const uint first = max(push.firstLight, deltas);
    vec4 light = lightOfAreas(receiver, seed, first - deltas, max(push.firstLight + push.lightCount, first) - deltas);
    if (kAddToAreas) {
        const vec4 before = imageLoad(areaLight, pixel);
        light = vec4(light.rgb + before.rgb, length(vec2(light.a, before.a)));
    }
    imageStore(areaLight, pixel, light);
}

void main() {
    const ivec2 tile = ivec2(gl_WorkGroupID.xy * tileSize());
    const ivec2 pixel = tile + pixelInTile(gl_LocalInvocationIndex) + ivec2(0, push.firstRow);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const GBufferPixel seen = readGBuffer(pixel, true);
    const uint seed = pixelSeed(frame.seed, pixel);
    uint count = push.lightCount;
    if (kAreasApart) {
        storeLightOfAreas(pixel, seen.receiver, seed);
        count = min(count, max(frame.deltaLightCount, push.firstLight) - push.firstLight);
    }
    vec3 radiance = radianceFromSum(seen.receiver, sumOfLights(seen.receiver, seed, push.firstLight, count));
    if (kGlossy && push.showEmission != 0u) radiance += reflectedLights(seen.receiver, seed);
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);

    if (push.showEmission != 0u) radiance += emissionSeenBy(pixel, seen.isSurface, seen.triangle);
    if (kAddToRadiance) radiance += imageLoad(radianceImage, pixel).rgb;
    imageStore(radianceImage, pixel, vec4(radiance, 1.0));
}
