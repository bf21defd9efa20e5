// From light to radiance: what was left out before the filter is multiplied in, and the radiance of the frame added.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/reconstruct.glsl"
#include "shaders/shared/workgroups.h"

layout(constant_id = 40) const bool kAddToRadiance = false;

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingReconstructed, rgba32f) readonly uniform image2D filtered;
layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    vec3 radiance = demodulator(readGBuffer(pixel, false).receiver) * imageLoad(filtered, pixel).rgb;
    if (kAddToRadiance) radiance += imageLoad(radianceImage, pixel).rgb;
    imageStore(radianceImage, pixel, vec4(radiance, 1.0));
}
