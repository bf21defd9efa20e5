// The loop over VPLs. Deferred and forward shading call the same function and differ only in where their receivers come
// from; the including file says how many it has (kReceivers) and which VPL list it reads.
#ifndef MANYLIGHT_SHADE_VPLS_GLSL
#define MANYLIGHT_SHADE_VPLS_GLSL
#include "shaders/lib/arriving.glsl"

// Instead of the bounded light, sums what the bound cuts off: an AOV.
layout(constant_id = 6) const bool kCutOff = false;

vec3 shareOfVpl(Receiver receiver, LightData vpl, float bound) {
    return kCutOff ? irradianceCutOff(receiver, vpl, bound) : irradianceOfVpl(receiver, vpl, bound);
}

// Adds the irradiance of VPLs [first, first + count). Blocks are summed apart, which keeps rounding small in long lists.
void shadeVpls(Receiver receivers[kReceivers], uint first, uint count, float bound, inout vec3 irradiance[kReceivers]) {
    for (uint base = first; base < first + count; base += kVplBlock) {
        loadVplBlock(base);
        vec3 blockSum[kReceivers];
        for (uint r = 0u; r < kReceivers; ++r) blockSum[r] = vec3(0.0);
        for (uint i = 0u; i < kVplBlock; ++i) {
            const LightData vpl = vplOfBlock(i);
            for (uint r = 0u; r < kReceivers; ++r)
                blockSum[r] += arriving(shareOfVpl(receivers[r], vpl, bound), receivers[r], vpl);
        }
        for (uint r = 0u; r < kReceivers; ++r) irradiance[r] += blockSum[r];
    }
}

#endif
