// Light that was found while the camera looked from elsewhere.
#ifndef MANYLIGHT_SHARED_TEMPORAL_H
#define MANYLIGHT_SHARED_TEMPORAL_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

MANYLIGHT_CONSTANT(float, kLongestHistory, 16.0f);  // frames; longer ones lag behind and blur

// The view that the history was seen from.
struct ReprojectionPush {
    vec3 origin;
    float frames;      // in the sum that was shown
    vec3 right;        // times the half width of the image plane at distance 1
    float areaShare;   // of a pixel of now in one of then, at most 1: frames of a coarser picture count as less
    vec3 down;         // times the half height
    uint sceneMoved;   // not the camera alone
    vec3 forward;
    uvec2 size;        // pixels
};

struct TemporalPush {
    float frames;  // in the sum, with this one
};

MANYLIGHT_SHARED_END
#endif
