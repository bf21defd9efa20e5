#ifndef MANYLIGHT_SHARED_SHOW_H
#define MANYLIGHT_SHARED_SHOW_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

MANYLIGHT_CONSTANT(uint, kShowNormal, 1u);
MANYLIGHT_CONSTANT(uint, kShowAlbedo, 2u);
MANYLIGHT_CONSTANT(uint, kShowDepth, 3u);
MANYLIGHT_CONSTANT(uint, kShowPosition, 4u);
MANYLIGHT_CONSTANT(uint, kShowMaterial, 5u);

struct ShowPush {
    uint channel;
    float depthScale;  // depth is shown as depth * depthScale
};

struct ShowVplsPush {
    float radius;      // of a dot, in pixels
    float brightness;  // of the brightest dot
};

// One dispatch counts over a stretch of the VPLs; see shaders/passes/show_rays.comp.
struct ShowRaysPush {
    uint firstVpl;
    uint endVpl;
    uint vplCount;    // of the whole list: as many rays are white
    uint shadowRays;  // drawn for a pixel that any VPL gives light; 0: a ray for each that does
    uint interleave;
    uint phase;
    uint firstRow;    // of the band of pixels
    uint gatherStep;  // as vpl_resample.comp has it
    uvec2 gridStart;
};

MANYLIGHT_SHARED_END
#endif
