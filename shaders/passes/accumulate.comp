// The running sum over frames; the first frame starts it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/tonemap.h"

layout(constant_id = 0) const bool kFirstFrame = false;

layout(local_size_x = kImageGroupWidth, local_size_y = kImageGroupHeight) in;
layout(set = 0, binding = kBindingRadiance, rgba32f) readonly uniform image2D radianceImage;
layout(set = 0, binding = kBindingRadianceSum, rgba32f) uniform image2D radianceSum;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    vec4 sum = imageLoad(radianceImage, pixel);
    if (!kFirstFrame) sum += imageLoad(radianceSum, pixel);
    imageStore(radianceSum, pixel, sum);
}
