// Unshadowed light times the filtered share of it that arrives.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingUnshadowed, rgba32f) readonly uniform image2D unshadowed;
layout(set = 0, binding = kBindingReconstructed, rgba32f) readonly uniform image2D visibility;
layout(set = 0, binding = kBindingReconstruction, rgba32f) writeonly uniform image2D light;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    imageStore(light, pixel, imageLoad(unshadowed, pixel) * vec4(imageLoad(visibility, pixel).rgb, 1.0));
}
