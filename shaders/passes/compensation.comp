// Adds what the bound cut off the light of the VPLs, for every pixel of the G-buffer.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/gbuffer_read.glsl"
#include "shaders/lib/compensation.glsl"
#include "shaders/lib/tile.glsl"

layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };

void main() {
    const ivec2 tile = ivec2(gl_WorkGroupID.xy * tileSize());
    const ivec2 pixel = tile + pixelInTile(gl_LocalInvocationIndex);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const GBufferPixel seen = readGBuffer(pixel, true);
    const vec3 lacking = compensation(seen.receiver, pixelSeed(frame.seed, pixel));
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);
    imageStore(radianceImage, pixel, vec4(imageLoad(radianceImage, pixel).rgb + lacking, 1.0));
}
