// Light, and filtered light added to it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingReconstructed, rgba32f) readonly uniform image2D filtered;
layout(set = 0, binding = kBindingReconstruction, rgba32f) uniform image2D sum;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    imageStore(sum, pixel, imageLoad(sum, pixel) + imageLoad(filtered, pixel));
}
