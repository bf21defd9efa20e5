// What is shown: the sum over the frames of this view, with what earlier views knew in place of frames that are still to
// come. When as many have come the sum alone is left, to the last bit.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/history.glsl"
#include "shaders/shared/workgroups.h"

layout(constant_id = 40) const bool kFirstFrame = false;
layout(constant_id = 41) const bool kHasHistory = false;

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingRadiance, rgba32f) readonly uniform image2D radianceImage;
layout(set = 0, binding = kBindingRadianceSum, rgba32f) readonly uniform image2D radianceSum;
layout(set = 0, binding = kBindingHistory, rgba32ui) uniform uimage2D history;
layout(set = 0, binding = kBindingShown, rgba32f) writeonly uniform image2D shownSum;
layout(set = 0, binding = kBindingHistoryGuide, rgba32ui) uniform uimage2D guide;
layout(push_constant, scalar) uniform Push { TemporalPush push; };

// How far single frames are from the mean, running over as many frames as a history has.
float scatterWith(float scatter, vec3 radiance, vec3 meanBefore, float framesBefore, float framesKnown) {
    const float level = max(brightness(radiance + meanBefore * framesBefore) / (framesBefore + 1.0), 1e-30);
    const float away = (brightness(radiance) - brightness(meanBefore)) / level;
    const float variance = away * away * framesBefore / (framesBefore + 1.0);  // its expectation is that of one frame
    return sqrt(mix(scatter * scatter, variance, 1.0 / clamp(framesKnown, 1.0, kLongestHistory)));
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const vec3 radiance = imageLoad(radianceImage, pixel).rgb;
    const vec3 sum = imageLoad(radianceSum, pixel).rgb;
    History earlier = History(vec3(0.0), 0.0, 0.0);
    if (kHasHistory)
        earlier = unpackHistory(imageLoad(history, pixel));
    else
        imageStore(history, pixel, packHistory(earlier));

    const float missing = max(earlier.frames - (push.frames - 1.0), 0.0);
    vec3 shown = sum;
    if (missing > 0.0) shown = push.frames / (missing + push.frames) * (missing * earlier.radiance + sum);
    imageStore(shownSum, pixel, vec4(shown, max(earlier.frames + 1.0, push.frames)));

    float scatter = earlier.scatter;
    if (kFirstFrame) {
        if (earlier.frames > 0.0)
            scatter = scatterWith(scatter, radiance, earlier.radiance, earlier.frames, earlier.frames);
    } else {
        const float before = push.frames - 1.0;
        scatter = scatterWith(unpackScatter(imageLoad(guide, pixel).w), radiance, (sum - radiance) / before, before,
                              max(earlier.frames, before));
    }
    imageStore(guide, pixel, historyGuide(readGBuffer(pixel, false), scatter));
}
