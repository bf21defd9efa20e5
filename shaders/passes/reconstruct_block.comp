// The mean over one period of the interleaving, as far as the pixels show one surface (Segovia et al. 2006): there it is
// the light of all subsets. The box has half pixels at its ends, where that makes it symmetric. Pixels that have not
// gathered get that mean too. Alpha becomes what is left to chance: the standard error of the mean of m subsets out of
// n * n, drawn without replacement (Cochran 1977, section 2.6), and that of the shadow rays.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/guide.glsl"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingReconstructed, rgba32f) readonly uniform image2D gathered;
layout(set = 0, binding = kBindingReconstruction, rgba32f) writeonly uniform image2D averaged;
layout(push_constant, scalar) uniform Push { BlockPush push; };

// Part of the pixel `offset` away that is in a box of this width.
float inBox(int offset, float width) { return clamp(0.5 * width + 0.5 - abs(float(offset)), 0.0, 1.0); }

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    const ivec2 last = ivec2(frame.imageSize) - 1;
    if (any(greaterThan(pixel, last))) return;
    const GuideCenter center = guideCenterAt(pixel);
    const float width = push.width;
    const int radius = takesPart(center) ? int(ceil(0.5 * width - 0.5)) : 0;

    vec3 sum = vec3(0.0);
    float weights = 0.0;
    float squaredErrors = 0.0;
    // Where no neighbour is like the pixel, those that are not tell how much it may be wrong.
    float spreadWeights = 0.0;
    vec2 moments = vec2(0.0);
    float scale = 0.0;  // over the first light that is met: squares of very faint light would underflow
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) {
            const ivec2 offset = ivec2(x, y);
            const vec4 tap = guideOfTap(pixel + offset);
            const vec4 light = imageLoad(gathered, clamp(pixel + offset, ivec2(0), last));
            const bool hasGathered = light.a >= 0.0;
            const float box = hasGathered ? inBox(x, width) * inBox(y, width) : 0.0;
            const float alike = takesPart(center) ? likeness(center, tap, vec2(offset), 0.0, kBlockNormalSharpness) : 0.0;
            const float w = hasGathered && offset == ivec2(0) ? 1.0 : box * alike;
            sum += w * light.rgb;
            weights += w;
            const float level = brightness(light.rgb);
            const float strength = max(level, light.a);
            if (scale == 0.0 && strength > 0.0) scale = 1.0 / strength;
            const float error = w * scale * light.a;
            squaredErrors += error * error;
            const float spreadWeight = tap.w > 0.0 ? max(w, 0.02 * box) : 0.0;
            const float relative = scale * level;
            spreadWeights += spreadWeight;
            moments += spreadWeight * vec2(relative, relative * relative);
        }
    if (weights == 0.0 || scale == 0.0) {
        imageStore(averaged, pixel, vec4(0.0));
        return;
    }
    moments /= max(spreadWeights, 1e-30);
    const float spread = max(moments.y - moments.x * moments.x, 0.0) * spreadWeights / max(spreadWeights - 1.0, 0.25);
    const float subsets = push.period * push.period;
    const float left = max(1.0 - weights / subsets, 0.0);
    const float error = sqrt(spread * left / weights + squaredErrors / (weights * weights)) / scale;
    imageStore(averaged, pixel, vec4(sum / weights, error));
}
