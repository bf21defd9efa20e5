// The sum of squared deviations from the mean, frame by frame (Welford 1962); it runs before the frame is added to the
// sum.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/workgroups.h"

layout(constant_id = 0) const bool kStarts = false;  // with the second frame

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingRadiance, rgba32f) readonly uniform image2D radianceImage;
layout(set = 0, binding = kBindingRadianceSum, rgba32f) readonly uniform image2D radianceSum;
layout(set = 0, binding = kBindingSquaredDeviations, rgba32f) uniform image2D squaredDeviations;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const float before = float(frame.frame);  // frames in the sum
    const vec3 deviation = imageLoad(radianceImage, pixel).rgb - imageLoad(radianceSum, pixel).rgb / before;
    vec3 sum = deviation * deviation * (before / (before + 1.0));
    if (!kStarts) sum += imageLoad(squaredDeviations, pixel).rgb;
    imageStore(squaredDeviations, pixel, vec4(sum, 1.0));
}
