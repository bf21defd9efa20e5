#ifndef MANYLIGHT_SHARED_VISIBILITY_RAYS_H
#define MANYLIGHT_SHARED_VISIBILITY_RAYS_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// Backs of single-sided surfaces one behind the other; a ray that meets more of them is reported.
MANYLIGHT_CONSTANT(uint, kMostBacksSeenThrough, 1024u);

struct VisibilityRaysPush {
    uint firstRow;  // of the band
    uint endRow;
};

MANYLIGHT_SHARED_END
#endif
