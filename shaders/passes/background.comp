// The environment's map, where no surface is seen.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/emission_seen.glsl"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    if (imageLoad(radianceImage, pixel).a != 0.0) return;
    imageStore(radianceImage, pixel, vec4(emissionSeenBy(pixel, false, 0u), 1.0));
}
