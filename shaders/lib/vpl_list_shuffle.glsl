// The VPL list for compute shaders: each lane of a subgroup loads one VPL and hands it round by shuffles.
#ifndef MANYLIGHT_VPL_LIST_GLSL
#define MANYLIGHT_VPL_LIST_GLSL
#extension GL_KHR_shader_subgroup_shuffle : require
#include "shaders/lib/glossy_vpls.glsl"
#include "shaders/lib/vpl_texels.glsl"

layout(constant_id = 11) const uint kVplBlock = 8u;  // the subgroup's size

vec4 heldPosition;   // and intensity
vec3 heldDirection;
vec3 heldColour;
vec4 heldGloss[kTexelsPerGloss];

// This lane's VPL of the next block.
void holdVpl(uint index) {
    const int mine = int(index * kTexelsPerLight);
    heldPosition = imageLoad(vplTexels, mine);
    heldDirection = imageLoad(vplTexels, mine + 1).xyz;
    heldColour = imageLoad(vplTexels, mine + 2).xyz;
    if (!kGlossy) return;
    const int gloss = int(index * kTexelsPerGloss);
    for (int t = 0; t < int(kTexelsPerGloss); ++t) heldGloss[t] = imageLoad(vplGloss, gloss + t);
}

void loadVplBlock(uint base) { holdVpl(base + gl_SubgroupInvocationID); }

VplGloss glossOfBlock(uint i) {
    return glossFromTexels(subgroupShuffle(heldGloss[0], i), subgroupShuffle(heldGloss[1], i),
                           subgroupShuffle(heldGloss[2], i), subgroupShuffle(heldGloss[3], i),
                           subgroupShuffle(heldGloss[4], i));
}

LightData vplOfBlock(uint i) {
    LightData vpl;
    const vec4 position = subgroupShuffle(heldPosition, i);
    vpl.position = position.xyz;
    vpl.intensity = position.w;
    vpl.direction = subgroupShuffle(heldDirection, i);
    vpl.colour = subgroupShuffle(heldColour, i);
    vpl.kind = kLightSurface;
    return vpl;
}

#endif
