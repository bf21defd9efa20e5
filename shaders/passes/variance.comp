// The sum of squared deviations from the mean, frame by frame (Welford 1962); it runs before the frame is added to the
// sum.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/tonemap.h"

layout(constant_id = 0) const bool kFirstFrame = false;

layout(local_size_x = kImageGroupWidth, local_size_y = kImageGroupHeight) in;
layout(set = 0, binding = kBindingRadiance, rgba32f) readonly uniform image2D radianceImage;
layout(set = 0, binding = kBindingRadianceSum, rgba32f) readonly uniform image2D radianceSum;
layout(set = 0, binding = kBindingSquaredDeviations, rgba32f) uniform image2D squaredDeviations;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    if (kFirstFrame) {
        imageStore(squaredDeviations, pixel, vec4(0.0));
        return;
    }
    const float before = float(frame.frame);  // frames in the sum
    const vec3 deviation = imageLoad(radianceImage, pixel).rgb - imageLoad(radianceSum, pixel).rgb / before;
    const vec3 sum = imageLoad(squaredDeviations, pixel).rgb + deviation * deviation * (before / (before + 1.0));
    imageStore(squaredDeviations, pixel, vec4(sum, 1.0));
}
