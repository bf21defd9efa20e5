// From light to radiance: what was left out before the filter is multiplied in, and the radiance of the frame added. Where a
// frame sees pixels at several points, light of VPLs is known at the first one; the others borrow it from pixels around them
// that show the same surface (visibility and shading decoupled: Ragan-Kelley et al. 2011).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/reconstruct.glsl"
#include "shaders/lib/guide.glsl"
#include "shaders/shared/workgroups.h"

layout(constant_id = 40) const bool kAddToRadiance = false;
layout(constant_id = 41) const bool kHasOwn = false;
layout(constant_id = 42) const bool kBorrows = false;

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingReconstructed, rgba32f) readonly uniform image2D ownLight;
layout(set = 0, binding = kBindingLentLight, rgba32f) readonly uniform image2D lentLight;
layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;
layout(push_constant, scalar) uniform Push { RemodulatePush push; };

const float kLeastLikeness = 1e-3;

// What nobody around shows is most likely hidden from light too: it takes the least that they have.
vec3 borrowedLight(ivec2 pixel, GBufferPixel seen) {
    if (!seen.isSurface) return vec3(0.0);
    const float depth = dot(seen.receiver.position - frame.cameraPosition, frame.cameraForward);
    const GuideCenter center = guideCenterOf(vec4(seen.receiver.normal, depth), pixel);
    vec4 sum = vec4(0.0);
    vec3 least = imageLoad(lentLight, pixel).rgb;
    bool isLentTo = false;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const ivec2 lender = pixel + ivec2(x, y);
            const vec2 offset = vec2(x, y) + push.toLender;
            const vec4 known = guideOfTap(lender);
            const vec3 light = imageLoad(lentLight, clamp(lender, ivec2(0), ivec2(frame.imageSize) - 1)).rgb;
            const float near = exp(-2.0 * dot(offset, offset));
            sum += near * likeness(center, known, offset, 0.0, kBlockNormalSharpness) * vec4(light, 1.0);
            if (known.w > 0.0 && (!isLentTo || brightness(light) < brightness(least))) least = light;
            isLentTo = isLentTo || known.w > 0.0;
        }
    return sum.a > kLeastLikeness ? sum.rgb / sum.a : least;
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const GBufferPixel seen = readGBuffer(pixel, false);
    vec3 light = vec3(0.0);
    if (kHasOwn) light += imageLoad(ownLight, pixel).rgb;
    if (kBorrows) light += borrowedLight(pixel, seen);
    vec3 radiance = demodulator(seen.receiver) * light;
    if (kAddToRadiance) radiance += imageLoad(radianceImage, pixel).rgb;
    imageStore(radianceImage, pixel, vec4(push.scale * radiance, 1.0));
}
