// The running sum over frames, with the rounding errors of all additions so far carried along (Kahan 1965): the sum of a
// million frames is as exact as that of two.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/workgroups.h"

layout(constant_id = 0) const bool kFirstFrame = false;

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingRadiance, rgba32f) readonly uniform image2D radianceImage;
layout(set = 0, binding = kBindingRadianceSum, rgba32f) uniform image2D radianceSum;
layout(set = 0, binding = kBindingRoundingError, rgba32f) uniform image2D roundingError;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const vec4 radiance = imageLoad(radianceImage, pixel);
    if (kFirstFrame) {
        imageStore(radianceSum, pixel, radiance);
        imageStore(roundingError, pixel, vec4(0.0));
        return;
    }
    const vec4 sum = imageLoad(radianceSum, pixel);
    precise vec4 addend = radiance - imageLoad(roundingError, pixel);
    precise vec4 total = sum + addend;
    precise vec4 error = (total - sum) - addend;
    imageStore(radianceSum, pixel, total);
    imageStore(roundingError, pixel, error);
}
