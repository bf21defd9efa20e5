// One level of the edge-avoiding a-trous wavelet (Dammertz et al. 2010), which stops at other surfaces and where
// brightness differs by more than its error explains (Schied et al. 2017). Alpha is that error. A tap counts as much as
// the one on the other side of the pixel, and no more: next to an edge a slope of the light would not cancel otherwise.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/guide.glsl"
#include "shaders/shared/bsdf.h"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingReconstructed, rgba32f) readonly uniform image2D coarser;
layout(set = 0, binding = kBindingReconstruction, rgba32f) writeonly uniform image2D smoother;
layout(push_constant, scalar) uniform Push { AtrousPush push; };

// Cubic B-spline, over its middle: 1, 2/3, 1/6.
float spline(int i) { return 1.0 - float(abs(i) * (3 + abs(i))) * (1.0 / 12.0); }

const float kLeastShare = 0.5;  // of a channel; the noise of fainter ones is beyond what the error of all says

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

// Of the channel that differs most for its share, in terms of brightness: where one light is in shadow and another of
// another colour is not, their sum may hide it. The error allowed is that of either: if only the center's counted,
// bright outliers would be thinned by others and give them nothing.
float differenceOf(vec4 light, vec3 own, float allowed) {
    const vec3 both = light.rgb + own;
    const float middle = brightness(both);
    const vec3 shares = middle > 0.0 ? max(both / middle, vec3(kLeastShare)) : vec3(1.0);
    const float apart = largestChannel(abs(light.rgb - own) / shares);
    const float allowedHere = max(allowed, push.deviations * light.a);
    return 8.0 * allowedHere > apart ? apart / allowedHere : 8.0;
}

float likenessTo(ivec2 pixel, ivec2 offset, GuideCenter center, float difference) {
    return likeness(center, guideOfTap(pixel + offset), vec2(offset), difference, kNormalSharpness);
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    const ivec2 last = ivec2(frame.imageSize) - 1;
    if (any(greaterThan(pixel, last))) return;
    const vec4 own = imageLoad(coarser, pixel);
    const GuideCenter center = guideCenterAt(pixel);
    const int radius = takesPart(center) ? 2 : -1;
    const int spacing = push.spacing;
    const float allowed = push.deviations * max(errorAround(pixel, own.a), own.a);

    vec3 sum = own.rgb;
    float weights = 1.0;
    const float worst = max(own.a, brightness(own.rgb));
    float squaredErrors = worst > 0.0 ? (own.a / worst) * (own.a / worst) : 0.0;
    for (int y = 0; y <= radius; ++y)
        for (int x = -2; x <= 2; ++x) {
            const ivec2 offset = spacing * ivec2(x, y);
            const vec4 light = imageLoad(coarser, clamp(pixel + offset, ivec2(0), last));
            const vec4 mirrored = imageLoad(coarser, clamp(pixel - offset, ivec2(0), last));
            const float alike = min(likenessTo(pixel, offset, center, differenceOf(light, own.rgb, allowed)),
                                    likenessTo(pixel, -offset, center, differenceOf(mirrored, own.rgb, allowed)));
            const float w = y > 0 || x > 0 ? spline(x) * spline(y) * alike : 0.0;
            sum += w * (light.rgb + mirrored.rgb);
            weights += 2.0 * w;
            const vec2 errors = worst > 0.0 ? w * (vec2(light.a, mirrored.a) / worst) : vec2(0.0);
            squaredErrors += dot(errors, errors);
        }
    imageStore(smoother, pixel, vec4(sum / weights, worst * sqrt(squaredErrors) / weights));
}
