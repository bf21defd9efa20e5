// The loop over VPLs. Deferred and forward shading call the same function and differ only in where their receivers come
// from; the including file says how many it has (kReceivers) and which VPL list it reads.
#ifndef MANYLIGHT_SHADE_VPLS_GLSL
#define MANYLIGHT_SHADE_VPLS_GLSL
#include "shaders/lib/arriving.glsl"

// Instead of the bounded light, sums what the bound cuts off: an AOV.
layout(constant_id = 14) const bool kCutOff = false;

// VPL i of the loaded block.
vec3 shareOfVpl(Receiver receiver, LightData vpl, uint i, float bound) {
    if (kGlossy) return summandOfGlossyVpl(receiver, vpl, glossOfBlock(i), bound, kCutOff);
    return kCutOff ? irradianceCutOff(receiver, vpl, bound) : irradianceOfVpl(receiver, vpl, bound);
}

// Adds the summands of VPLs [first, first + count). Blocks are summed apart, which keeps rounding small in long lists.
void shadeVpls(Receiver receivers[kReceivers], uint first, uint count, float bound, inout vec3 sums[kReceivers]) {
    for (uint base = first; base < first + count; base += kVplBlock) {
        loadVplBlock(base);
        vec3 blockSum[kReceivers];
        for (uint r = 0u; r < kReceivers; ++r) blockSum[r] = vec3(0.0);
        for (uint i = 0u; i < kVplBlock; ++i) {
            const LightData vpl = vplOfBlock(i);
            for (uint r = 0u; r < kReceivers; ++r)
                blockSum[r] += arriving(shareOfVpl(receivers[r], vpl, i, bound), receivers[r], vpl);
        }
        for (uint r = 0u; r < kReceivers; ++r) sums[r] += blockSum[r];
    }
}

#endif
