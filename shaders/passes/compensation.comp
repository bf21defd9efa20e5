// Adds what the bound cut off the light of the VPLs, for every pixel of the G-buffer, to the radiance or to what is filtered
// yet.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/gbuffer_read.glsl"
#include "shaders/lib/compensation.glsl"
#include "shaders/lib/reconstruct.glsl"
#include "shaders/lib/tile.glsl"

layout(constant_id = 40) const bool kForReconstruction = false;

layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };

// Where a Lambertian's albedo would cancel it is never multiplied in: it may be 0.
vec3 demodulatedCompensation(Receiver receiver, uint seed) {
    if (isGlossy(receiver.bsdf.f90)) return compensation(receiver, seed) / demodulator(receiver);
    receiver.bsdf.diffuse = vec3(1.0);
    return compensation(receiver, seed);
}

// One sample, which is 0 most often: its square is what is known of its variance. Pixels that do not gather get none.
void addToLight(ivec2 pixel, Receiver receiver, uint seed) {
    const vec4 light = imageLoad(radianceImage, pixel);
    if (light.a < 0.0) return;
    const vec3 lacking = demodulatedCompensation(receiver, seed);
    imageStore(radianceImage, pixel, vec4(light.rgb + lacking, length(vec2(light.a, brightness(lacking)))));
}

void main() {
    const ivec2 tile = ivec2(gl_WorkGroupID.xy * tileSize());
    const ivec2 pixel = tile + pixelInTile(gl_LocalInvocationIndex);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const Receiver receiver = readGBuffer(pixel, true).receiver;
    const uint seed = pixelSeed(frame.seed, pixel);
    if (kForReconstruction) {
        addToLight(pixel, receiver, seed);
    } else {
        const vec3 radiance = imageLoad(radianceImage, pixel).rgb + compensation(receiver, seed);
        imageStore(radianceImage, pixel, vec4(radiance, 1.0));
    }
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);
}
