// From the G-buffer to what the filter reads of it: normal, and depth along the camera's axis; 0 where light is shared
// with no neighbour.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/reconstruct.glsl"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingGuide, rgba32f) writeonly uniform image2D guide;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const Guide own = guideAt(pixel);
    const float depth = dot(own.position - frame.cameraPosition, frame.cameraForward);
    imageStore(guide, pixel, vec4(own.normal, own.takesPart ? max(depth, 0.0) : 0.0));
}
