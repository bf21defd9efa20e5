// The VPL list for fragment shaders: a uniform buffer, read by the loop counter.
#ifndef MANYLIGHT_VPL_LIST_GLSL
#define MANYLIGHT_VPL_LIST_GLSL
#include "shaders/shared/lights.h"
#include "shaders/shared/vpl_light.h"

const uint kVplBlock = 8u;  // divides kVplPadding

layout(set = 0, binding = kBindingVpls, scalar) uniform VplBlock { LightData vpls[kMaxForwardVplsPerDraw]; };

uint blockBase;

void loadVplBlock(uint base) { blockBase = base; }

LightData vplOfBlock(uint i) {
    LightData vpl = vpls[blockBase + i];
    vpl.kind = kLightSurface;
    return vpl;
}

#endif
