// One level of the edge-avoiding a-trous wavelet (Dammertz et al. 2010), which stops at other surfaces and where
// brightness differs by more than its error explains (Schied et al. 2017). Alpha is that error.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/reconstruct.glsl"
#include "shaders/shared/reconstruct.h"
#include "shaders/shared/tonemap.h"

layout(local_size_x = kImageGroupWidth, local_size_y = kImageGroupHeight) in;
layout(set = 0, binding = kBindingReconstructed, rgba32f) readonly uniform image2D coarser;
layout(set = 0, binding = kBindingReconstruction, rgba32f) writeonly uniform image2D smoother;
layout(push_constant, scalar) uniform Push { AtrousPush push; };

// Cubic B-spline, over its middle.
const float kSpline[3] = {1.0, 2.0 / 3.0, 1.0 / 6.0};

// Errors scatter too: their mean over neighbours, by a Gaussian.
float errorAround(ivec2 pixel) {
    float sum = 0.0;
    float weights = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            if (!isInPicture(pixel + ivec2(x, y))) continue;
            const float w = (x == 0 ? 2.0 : 1.0) * (y == 0 ? 2.0 : 1.0);
            sum += w * imageLoad(coarser, pixel + ivec2(x, y)).a;
            weights += w;
        }
    return sum / weights;
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const vec4 own = imageLoad(coarser, pixel);
    const Guide center = guideAt(pixel);
    const int radius = center.takesPart ? 2 : 0;
    const int spacing = push.spacing;
    const float footprint = footprintAt(center.position);
    const float level = brightness(own.rgb);
    const float allowed = push.deviations * max(errorAround(pixel), own.a);

    vec3 sum = own.rgb;
    float weights = 1.0;
    float worst = max(own.a, level);
    float squaredErrors = worst > 0.0 ? (own.a / worst) * (own.a / worst) : 0.0;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) {
            const ivec2 offset = spacing * ivec2(x, y);
            if (offset == ivec2(0) || !isInPicture(pixel + offset)) continue;
            const vec4 light = imageLoad(coarser, pixel + offset);
            const float difference = abs(brightness(light.rgb) - level);
            const float likely = difference < 80.0 * allowed ? exp(-difference / allowed) : 0.0;
            const float w = kSpline[abs(x)] * kSpline[abs(y)] * likely *
                            sameSurface(center, guideAt(pixel + offset), footprint, offset);
            sum += w * light.rgb;
            weights += w;
            const float error = worst > 0.0 ? w * light.a / worst : 0.0;
            squaredErrors += error * error;
        }
    imageStore(smoother, pixel, vec4(sum / weights, worst * sqrt(squaredErrors) / weights));
}
