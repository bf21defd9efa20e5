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

MANYLIGHT_SHARED_END
#endif
