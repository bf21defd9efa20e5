// The VPL list for fragment shaders: a uniform buffer, read by the loop counter.
#ifndef MANYLIGHT_VPL_LIST_GLSL
#define MANYLIGHT_VPL_LIST_GLSL
#include "shaders/lib/glossy_vpls.glsl"
#include "shaders/shared/vpl_light.h"

const uint kVplBlock = 8u;  // divides kVplPadding

layout(set = 0, binding = kBindingVpls, scalar) uniform VplBlock { LightData vpls[kMaxForwardVplsPerDraw]; };

uint blockBase;
uint firstGloss;  // what the first VPL of the uniform buffer is in the list of glossy ones

void loadVplBlock(uint base) { blockBase = base; }

VplGloss glossOfBlock(uint i) { return loadGloss(firstGloss + blockBase + i); }

LightData vplOfBlock(uint i) {
    LightData vpl = vpls[blockBase + i];
    vpl.kind = kLightSurface;
    return vpl;
}

#endif
