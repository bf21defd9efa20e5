// How many shadow rays a pixel asks for: one for every VPL that would give it light if nothing were between, or as many as
// are drawn from those.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/gbuffer_read.glsl"
#include "shaders/lib/vpl_list_shuffle.glsl"
#include "shaders/lib/tile.glsl"
#include "shaders/lib/gather_grid.glsl"
#include "shaders/shared/show.h"

layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;  // its alpha: VPLs counted so far
layout(push_constant, scalar) uniform Push { ShowRaysPush push; };

// Black, red, yellow, white.
vec3 heat(float share) { return clamp(3.0 * share - vec3(0.0, 1.0, 2.0), 0.0, 1.0); }

bool givesLight(Receiver receiver, uint i) {
    const LightData vpl = vplOfBlock(i);
    const vec3 share = kGlossy ? summandOfGlossyVpl(receiver, vpl, glossOfBlock(i), frame.geometryBound, false)
                               : irradianceOfVpl(receiver, vpl, frame.geometryBound);
    const bool isInFront = dot(receiver.geometricNormal, vpl.position - receiver.position) > 0.0;
    return isInFront && share.x + share.y + share.z > 0.0;
}

// Of the pixel's subset: see vpl_resample.comp.
uint countVpls(Receiver receiver, uvec2 pixel) {
    const uint period = push.interleave / push.gatherStep;
    const uint step = period * period;
    const uvec2 inPeriod = pixel % push.interleave / push.gatherStep;
    const uint mine = (inPeriod.y * period + inPeriod.x + push.phase) % step;
    uint count = 0u;
    for (uint base = push.firstVpl; base < push.endVpl; base += kVplBlock) {
        loadVplBlock(base);
        for (uint i = 0u; i < kVplBlock; ++i)
            if (givesLight(receiver, i) && (base + i) % step == mine) ++count;
    }
    return count;
}

void main() {
    // No early return: every lane holds a VPL for the others.
    const ivec2 tile = ivec2(gl_WorkGroupID.xy * tileSize());
    const ivec2 pixel = tile + pixelInTile(gl_LocalInvocationIndex) + ivec2(0, push.firstRow);
    uint count = countVpls(readGBuffer(pixel, true).receiver, uvec2(pixel));
    if (push.gatherStep > 1u && !gathersItself(pixel, int(push.gatherStep), ivec2(push.gridStart))) count = 0u;
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    if (push.firstVpl > 0u) count += uint(imageLoad(radianceImage, pixel).a);
    const uint rays = push.shadowRays == 0u || count == 0u ? count : push.shadowRays;
    imageStore(radianceImage, pixel, vec4(heat(float(rays) / float(max(push.vplCount, 1u))), float(count)));
}
