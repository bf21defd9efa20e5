// The filter that puts an interleaved gather together again.
#ifndef MANYLIGHT_SHARED_RECONSTRUCT_H
#define MANYLIGHT_SHARED_RECONSTRUCT_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

MANYLIGHT_CONSTANT(float, kPlaneTolerance, 1.0f);     // off the plane per pixel of distance in the picture, footprints
// How soon normals are too different, as the exponent of the cosine between them, about. One pixel has light of few VPLs,
// and what is round in the picture has few pixels: the first filter takes neighbours that the others would not.
MANYLIGHT_CONSTANT(float, kNormalSharpness, 32.0f);
MANYLIGHT_CONSTANT(float, kBlockNormalSharpness, 8.0f);

// Mean of the channels: of light that has the same spectrum everywhere, any mixture would do.
MANYLIGHT_FUNCTION float brightness(vec3 v) { return (v.x + v.y + v.z) * (1.0f / 3.0f); }

struct BlockPush {
    float width;   // of the box, pixels; the period of the interleaving meets every subset equally often
    float period;  // n
};

struct VisibilityPush {
    float width;   // as of BlockPush
    float period;
    float rays;    // that a pixel has sent
};

struct RemodulatePush {
    vec2 toLender;  // pixels, from this G-buffer's points to those where light is known
    float scale;    // of the sum
};

struct AtrousPush {
    int spacing;       // of the taps, pixels
    float deviations;  // how far apart two pixels may be in brightness
};

MANYLIGHT_SHARED_END
#endif
