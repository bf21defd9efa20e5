// As reconstruct_block.comp, of light and its visibility apart (Heitz et al. 2018): the mean of the unshadowed light, which
// has no noise but that of the subsets, and the share of it that arrives. Alpha of the latter is its standard error, from
// the shadow rays, of which each says yes or no, and from the subsets that are missing.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/guide.glsl"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingReconstructed, rgba32f) readonly uniform image2D gathered;
layout(set = 0, binding = kBindingUnshadowed, rgba32f) writeonly uniform image2D unshadowed;
layout(set = 0, binding = kBindingReconstruction, rgba32f) writeonly uniform image2D visibility;
layout(push_constant, scalar) uniform Push { VisibilityPush push; };

float inBox(int offset, float width) { return clamp(0.5 * width + 0.5 - abs(float(offset)), 0.0, 1.0); }

float varianceOfShare(float share) { return push.rays > 1.0 ? share * (1.0 - share) / (push.rays - 1.0) : 0.25; }

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    const ivec2 last = ivec2(frame.imageSize) - 1;
    if (any(greaterThan(pixel, last))) return;
    const GuideCenter center = guideCenterAt(pixel);
    const int radius = takesPart(center) ? int(ceil(0.5 * push.width - 0.5)) : 0;

    vec3 sum = vec3(0.0);
    float weights = 0.0;
    float strengths = 0.0;
    vec2 moments = vec2(0.0);  // of the share
    float squaredErrors = 0.0;
    float scale = 0.0;  // over the first light that is met: squares of very faint light would underflow
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) {
            const ivec2 offset = ivec2(x, y);
            const vec4 tap = guideOfTap(pixel + offset);
            const vec4 light = imageLoad(gathered, clamp(pixel + offset, ivec2(0), last));
            const bool hasGathered = light.a >= 0.0;
            const float box = hasGathered ? inBox(x, push.width) * inBox(y, push.width) : 0.0;
            const float alike = takesPart(center) ? likeness(center, tap, vec2(offset), 0.0, kBlockNormalSharpness) : 0.0;
            const float w = hasGathered && offset == ivec2(0) ? 1.0 : box * alike;
            sum += w * light.rgb;
            weights += w;
            const float level = brightness(light.rgb);
            if (scale == 0.0 && level > 0.0) scale = 1.0 / level;
            const float strength = w * scale * level;
            const float share = max(light.a, 0.0);
            strengths += strength;
            moments += strength * vec2(share, share * share);
            squaredErrors += strength * strength * varianceOfShare(share);
        }
    if (strengths == 0.0) {
        imageStore(unshadowed, pixel, vec4(0.0));
        imageStore(visibility, pixel, vec4(0.0));
        return;
    }
    moments /= strengths;
    const float spread = max(moments.y - moments.x * moments.x, 0.0);
    const float left = max(1.0 - weights / (push.period * push.period), 0.0);
    const float error = sqrt(squaredErrors / (strengths * strengths) + spread * left / max(weights, 1.0));
    imageStore(unshadowed, pixel, vec4(sum / weights, 1.0));
    imageStore(visibility, pixel, vec4(vec3(moments.x), error));
}
