// Emission and the light of the real lights, for every pixel of the G-buffer.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/gbuffer_read.glsl"
#include "shaders/lib/emission_seen.glsl"
#include "shaders/lib/tile.glsl"

const uint kReceivers = 1u;
const uint kVplBlock = 1u;  // no VPLs here
void loadVplBlock(uint base) {}
LightData vplOfBlock(uint i) { return LightData(vec3(0.0), 0.0, vec3(0.0), 0u, vec3(0.0), 0.0, 0.0, 0u, 0u, 0u); }
#include "shaders/lib/shade_lights.glsl"

layout(constant_id = 4) const bool kAddToRadiance = false;

layout(local_size_x = kVplGroupSize) in;
layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { ShadePush push; };

void main() {
    const ivec2 tile = ivec2(gl_WorkGroupID.xy) * ivec2(kVplTileWidth, kVplTileHeight);
    const ivec2 pixel = tile + pixelInTile(gl_LocalInvocationIndex);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const GBufferPixel seen = readGBuffer(pixel, true);
    Receiver receivers[kReceivers] = {seen.receiver};
    vec3 irradiance[kReceivers] = {vec3(0.0)};
    shadeLights(receivers, push.firstLight, push.lightCount, irradiance);
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);

    vec3 radiance = seen.albedo * kInvPi * irradiance[0];
    if (push.showEmission != 0u)
        radiance += radianceEmittedTowards(seen.isSurface, seen.triangle, -cameraDirection(pixel));
    if (kAddToRadiance) radiance += imageLoad(radianceImage, pixel).rgb;
    imageStore(radianceImage, pixel, vec4(radiance, 1.0));
}
