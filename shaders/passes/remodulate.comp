// From light to radiance: what was left out before the filter is multiplied in, and what the camera sees of the lights
// themselves is added. Where a frame sees pixels at several points, light is known at the first one; the others borrow it
// from pixels around them that show the same surface (visibility and shading decoupled: Ragan-Kelley et al. 2011).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/emission_seen.glsl"
#include "shaders/lib/reconstruct.glsl"
#include "shaders/lib/guide.glsl"
#include "shaders/shared/workgroups.h"

layout(constant_id = 40) const bool kShowEmission = false;
layout(constant_id = 41) const bool kBorrows = false;

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingReconstructed, rgba32f) readonly uniform image2D lightImage;
layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;
layout(push_constant, scalar) uniform Push { RemodulatePush push; };

const int kSharpnessLog2 = 3;     // light may come from where the normal is a little different: it was smoothed farther
const float kLeastLikeness = 1e-9;

// Light at a further point of the pixel, and 1; 0 if nothing around shows its surface.
vec4 borrowedLight(ivec2 pixel, GBufferPixel seen) {
    if (!seen.isSurface) return vec4(0.0, 0.0, 0.0, 1.0);
    if (kGlossy && isGlossy(seen.receiver.bsdf.f90) && seen.receiver.bsdf.alpha < kRoughestLeftAlone) return vec4(0.0);
    const float depth = dot(seen.receiver.position - frame.cameraPosition, frame.cameraForward);
    const GuideCenter center = guideCenterOf(vec4(seen.receiver.normal, depth), pixel);
    vec4 sum = vec4(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const ivec2 tap = pixel + ivec2(x, y);
            const vec2 offset = vec2(x, y) + push.toLight;
            const float near = exp(-2.0 * dot(offset, offset));
            const vec4 tapGuide = guideOfTap(tap);
            const float w = near * max(likeness(center, tapGuide, offset, 0.0, kSharpnessLog2), tapGuide.w > 0.0 ? 1e-3 : 0.0);
            sum += w * vec4(imageLoad(lightImage, clamp(tap, ivec2(0), ivec2(frame.imageSize) - 1)).rgb, 1.0);
        }
    return sum.a > kLeastLikeness ? vec4(sum.rgb / sum.a, 1.0) : vec4(0.0);
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const GBufferPixel seen = readGBuffer(pixel, false);
    vec4 light;
    if (kBorrows)
        light = borrowedLight(pixel, seen);
    else
        light = vec4(imageLoad(lightImage, pixel).rgb, 1.0);
    vec3 radiance = demodulator(seen.receiver) * light.rgb;
    if (kShowEmission) radiance += emissionSeenBy(pixel, seen.isSurface, seen.triangle);
    vec4 sum = light.a * vec4(radiance, 1.0);
    if (kBorrows) sum += imageLoad(radianceImage, pixel);
    imageStore(radianceImage, pixel, push.isLast != 0u ? vec4(sum.rgb / sum.a, 1.0) : sum);
}
