// The filter that puts an interleaved gather together again.
#ifndef MANYLIGHT_SHARED_RECONSTRUCT_H
#define MANYLIGHT_SHARED_RECONSTRUCT_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

struct BlockPush {
    float width;   // of the box, pixels; the period of the interleaving meets every subset equally often
    float period;  // n
};

struct AtrousPush {
    int spacing;       // of the taps, pixels
    float deviations;  // how far apart two pixels may be in brightness
};

MANYLIGHT_SHARED_END
#endif
