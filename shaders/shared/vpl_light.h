#ifndef MANYLIGHT_SHARED_VPL_LIGHT_H
#define MANYLIGHT_SHARED_VPL_LIGHT_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// The VPL list is padded with dark entries to a multiple of this, which every subgroup size divides.
MANYLIGHT_CONSTANT(uint, kVplPadding, 128u);

// lavapipe ends every loop silently after this many iterations of an invocation, all its loops together. A shadow ray
// takes tens of them, 200 at worst; the traversal reports if it was cut off all the same.
MANYLIGHT_CONSTANT(uint, kLoopBudget, 65535u);
MANYLIGHT_CONSTANT(uint, kMaxShadowedVplsPerDispatch, 256u);
MANYLIGHT_CONSTANT(uint, kMaxVplsPerDispatch, 8192u);
// A dispatch covers as many rows of the picture as keep it below this work, so that no driver's watchdog ends it: at a
// hundred million rays a second, a sixth of a second.
MANYLIGHT_CONSTANT(uint, kMaxRaysInDispatch, 1u << 24);
MANYLIGHT_CONSTANT(uint, kMaxPairsInDispatch, 1u << 30);  // pixels and VPLs without rays
// A uniform buffer of 64 KiB holds this many.
MANYLIGHT_CONSTANT(uint, kMaxForwardVplsPerDraw, 1024u);

// One dispatch or draw shades a stretch of the real lights and then a stretch of the VPLs.
struct ShadePush {
    uint firstLight;
    uint lightCount;
    uint firstVpl;
    uint vplCount;
    uint showEmission;  // the camera sees lights and the environment; set for the first stretch only
    uint firstRow;      // of the band of pixels that a dispatch shades
    uint firstGloss;    // number in the whole list of the VPL that firstVpl is in the bound one
};

MANYLIGHT_SHARED_END
#endif
