// One level of the edge-avoiding a-trous wavelet (Dammertz et al. 2010), which stops at other surfaces and where
// brightness differs by more than its error explains (Schied et al. 2017). Alpha is that error.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/guide.glsl"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingReconstructed, rgba32f) readonly uniform image2D coarser;
layout(set = 0, binding = kBindingReconstruction, rgba32f) writeonly uniform image2D smoother;
layout(push_constant, scalar) uniform Push { AtrousPush push; };

// Cubic B-spline, over its middle: 1, 2/3, 1/6.
float spline(int i) { return 1.0 - float(abs(i) * (3 + abs(i))) * (1.0 / 12.0); }

// Errors scatter too: their mean over neighbours.
float errorAround(ivec2 pixel, float own) {
    float sum = 4.0 * own;
    for (int i = 0; i < 4; ++i) {
        const ivec2 side = (i & 1) == 0 ? ivec2(i - 1, 0) : ivec2(0, i - 2);
        const ivec2 inside = clamp(pixel + side, ivec2(0), ivec2(frame.imageSize) - 1);
        sum += imageLoad(coarser, inside).a;
    }
    return sum * (1.0 / 8.0);
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    const ivec2 last = ivec2(frame.imageSize) - 1;
    if (any(greaterThan(pixel, last))) return;
    const vec4 own = imageLoad(coarser, pixel);
    const GuideCenter center = guideCenterAt(pixel);
    const int radius = takesPart(center) ? 2 : -1;
    const int spacing = push.spacing;
    const float level = brightness(own.rgb);
    const float allowed = push.deviations * max(errorAround(pixel, own.a), own.a);

    vec3 sum = own.rgb;
    float weights = 1.0;
    const float worst = max(own.a, level);
    float squaredErrors = worst > 0.0 ? (own.a / worst) * (own.a / worst) : 0.0;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -2; x <= 2; ++x) {
            const ivec2 offset = spacing * ivec2(x, y);
            const vec4 tap = guideOfTap(pixel + offset);
            const vec4 light = imageLoad(coarser, clamp(pixel + offset, ivec2(0), last));
            const float apart = abs(brightness(light.rgb) - level);
            // Of either: if only the center's counted, bright outliers would be thinned by others and give them nothing.
            const float allowedHere = max(allowed, push.deviations * light.a);
            const float difference = 8.0 * allowedHere > apart ? apart / allowedHere : 8.0;
            const float alike = spline(x) * spline(y) * likeness(center, tap, offset, difference);
            const float w = offset == ivec2(0) ? 0.0 : alike;
            sum += w * light.rgb;
            weights += w;
            const float error = worst > 0.0 ? w * (light.a / worst) : 0.0;
            squaredErrors += error * error;
        }
    imageStore(smoother, pixel, vec4(sum / weights, worst * sqrt(squaredErrors) / weights));
}
