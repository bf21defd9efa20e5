#ifndef MANYLIGHT_SHARED_TONEMAP_H
#define MANYLIGHT_SHARED_TONEMAP_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

MANYLIGHT_CONSTANT(uint, kToneLinear, 0u);    // clamp
MANYLIGHT_CONSTANT(uint, kToneReinhard, 1u);  // luminance, Reinhard et al. 2002 eq. 4 with a white point
MANYLIGHT_CONSTANT(uint, kToneAces, 2u);      // Narkowicz' fit of the ACES curve

struct TonemapPush {
    float scale;  // exposure / number of frames summed
    uint curve;
};

MANYLIGHT_SHARED_END
#endif
