// Post-processing, last: exposure, tone curve, display encoding.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/tonemap.h"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingRadianceSum, rgba32f) readonly uniform image2D radianceSum;
layout(set = 0, binding = kBindingDisplay, rgba8) writeonly uniform image2D display;
layout(push_constant, scalar) uniform Push { TonemapPush push; };

const float kReinhardWhite = 4.0;

vec3 toneCurve(vec3 radiance) {
    if (push.curve == kToneReinhard) {
        const float luminance = dot(radiance, vec3(0.2126, 0.7152, 0.0722));
        return radiance * ((1.0 + luminance / (kReinhardWhite * kReinhardWhite)) / (1.0 + luminance));
    }
    if (push.curve == kToneAces)
        return radiance * (2.51 * radiance + 0.03) / (radiance * (2.43 * radiance + 0.59) + 0.14);
    return radiance;
}

vec3 srgbFromLinear(vec3 linear) {
    const vec3 high = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
    return mix(high, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const vec3 radiance = imageLoad(radianceSum, pixel).rgb * push.scale;
    imageStore(display, pixel, vec4(srgbFromLinear(clamp(toneCurve(radiance), 0.0, 1.0)), 1.0));
}
