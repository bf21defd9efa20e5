// From the visible triangle to the G-buffer, once per pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/camera.glsl"
#include "shaders/lib/gbuffer.glsl"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingVisibility, r32ui) readonly uniform uimage2D visibility;
layout(set = 0, binding = kBindingGBufferPosition, rgba32ui) writeonly uniform uimage2D gbufferPosition;
layout(set = 0, binding = kBindingGBufferShading, rgba32ui) writeonly uniform uimage2D gbufferShading;
layout(set = 0, binding = kBindingGBufferGloss, rgba32ui) writeonly uniform uimage2D gbufferGloss;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const uint seen = imageLoad(visibility, pixel).x;
    GBufferTexels texels = GBufferTexels(uvec4(0u), uvec4(0u), uvec4(0u));
    if (seen != 0u) texels = packGBuffer(surfaceOfPixel(seen - 1u, pixel), seen - 1u);
    imageStore(gbufferPosition, pixel, texels.position);
    imageStore(gbufferShading, pixel, texels.shading);
    if (kGlossy) imageStore(gbufferGloss, pixel, texels.gloss);
}
