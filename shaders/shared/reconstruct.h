// The filter that puts an interleaved gather together again.
#ifndef MANYLIGHT_SHARED_RECONSTRUCT_H
#define MANYLIGHT_SHARED_RECONSTRUCT_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

MANYLIGHT_CONSTANT(float, kPlaneTolerance, 1.0f);     // off the plane per pixel of distance in the picture, footprints
MANYLIGHT_CONSTANT(int, kNormalSharpnessLog2, 6);  // of the exponent of the cosine between normals

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
    vec2 toLight;  // pixels, from this G-buffer's points to those where light is known
    uint isLast;   // of the points of a pixel
};

struct AtrousPush {
    int spacing;       // of the taps, pixels
    float deviations;  // how far apart two pixels may be in brightness
};

MANYLIGHT_SHARED_END
#endif
