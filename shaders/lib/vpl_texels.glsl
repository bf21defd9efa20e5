// The VPL list as texels. Texel loads are twice as fast as storage-buffer loads on a software driver, and no slower on a
// GPU.
#ifndef MANYLIGHT_VPL_TEXELS_GLSL
#define MANYLIGHT_VPL_TEXELS_GLSL
#include "shaders/shared/lights.h"

layout(set = 0, binding = kBindingVplTexels, rgba32f) readonly uniform imageBuffer vplTexels;

// One VPL out of turn; what only real lights have is left out.
LightData loadVpl(uint i) {
    const int first = int(i * kTexelsPerLight);
    const vec4 position = imageLoad(vplTexels, first);
    LightData vpl;
    vpl.position = position.xyz;
    vpl.intensity = position.w;
    vpl.direction = imageLoad(vplTexels, first + 1).xyz;
    vpl.kind = kLightSurface;
    vpl.colour = imageLoad(vplTexels, first + 2).xyz;
    vpl.depth = floatBitsToUint(imageLoad(vplTexels, first + 3).y);
    return vpl;
}

#endif
