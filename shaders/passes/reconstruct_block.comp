// The mean over one period of the interleaving, as far as the pixels show one surface (Segovia et al. 2006): there it is
// the light of all subsets. The box has half pixels at its ends, where that makes it symmetric. Alpha becomes what is
// left to chance: the standard error of the mean of m subsets out of n * n, drawn without replacement (Cochran 1977,
// section 2.6), and that of the shadow rays.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/reconstruct.glsl"
#include "shaders/shared/reconstruct.h"
#include "shaders/shared/tonemap.h"

layout(local_size_x = kImageGroupWidth, local_size_y = kImageGroupHeight) in;
layout(set = 0, binding = kBindingReconstructed, rgba32f) readonly uniform image2D gathered;
layout(set = 0, binding = kBindingReconstruction, rgba32f) writeonly uniform image2D averaged;
layout(push_constant, scalar) uniform Push { BlockPush push; };

// Part of the pixel `offset` away that is in a box of this width.
float inBox(int offset, float width) { return clamp(0.5 * width + 0.5 - abs(float(offset)), 0.0, 1.0); }

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const vec4 own = imageLoad(gathered, pixel);
    const Guide center = guideAt(pixel);
    const float width = push.width;
    const int radius = center.takesPart ? int(ceil(0.5 * width - 0.5)) : 0;
    const float footprint = footprintAt(center.position);
    // Relative to the pixel itself: squares of very faint light would underflow.
    const float scale = brightness(own.rgb) > 0.0 ? 1.0 / brightness(own.rgb) : 1.0;

    vec3 sum = vec3(0.0);
    float weights = 0.0;
    float squaredErrors = 0.0;
    // Where no neighbour is like the pixel, those that are not tell how much it may be wrong.
    float spreadWeights = 0.0;
    vec2 moments = vec2(0.0);
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) {
            const ivec2 offset = ivec2(x, y);
            if (!isInPicture(pixel + offset)) continue;
            const Guide tap = guideAt(pixel + offset);
            const float box = inBox(x, width) * inBox(y, width);
            const float w = offset == ivec2(0) ? 1.0 : box * sameSurface(center, tap, footprint, offset);
            const vec4 light = imageLoad(gathered, pixel + offset);
            sum += w * light.rgb;
            weights += w;
            squaredErrors += (w * scale * light.a) * (w * scale * light.a);
            const float spreadWeight = tap.takesPart ? max(w, 0.02 * box) : 0.0;
            const float relative = scale * brightness(light.rgb);
            spreadWeights += spreadWeight;
            moments += spreadWeight * vec2(relative, relative * relative);
        }
    moments /= max(spreadWeights, 1e-30);
    const float spread = max(moments.y - moments.x * moments.x, 0.0) * spreadWeights / max(spreadWeights - 1.0, 0.25);
    const float subsets = push.period * push.period;
    const float left = max(1.0 - weights / subsets, 0.0);
    const float error = sqrt(spread * left / weights + squaredErrors / (weights * weights)) / scale;
    imageStore(averaged, pixel, vec4(sum / weights, error));
}
