// The VPL list of exactly `vplCount` entries: all vertices of the light paths if they fit, else a stratified sample of
// them. With M vertices, entry i takes vertex floor((i M + r_i) / V), every r_i uniform in [0, M): each vertex is taken V / M
// times on average and weighs M / V, so the list's expectation is that of all vertices. One r for all entries would take
// vertices at equal distances, and from paths of equal length those of one depth alone.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/random.glsl"
#include "shaders/shared/lights.h"
#include "shaders/shared/vpl_emission.h"
#include "shaders/shared/workgroups.h"

layout(constant_id = 2) const bool kGlossy = true;  // as in surface.glsl

layout(local_size_x_id = kConstantGroupWidth) in;
layout(set = 0, binding = kBindingPathOffsets, scalar) readonly buffer PathBlock { uint pathOffsets[]; };
layout(set = 0, binding = kBindingPathVertices, scalar) readonly buffer VertexBlock { LightData pathVertices[]; };
layout(set = 0, binding = kBindingVpls, scalar) writeonly buffer VplBlock { LightData vpls[]; };
layout(set = 0, binding = kBindingPathGloss, scalar) readonly buffer PathGlossBlock { VplGloss pathGloss[]; };
layout(set = 0, binding = kBindingVplGloss, scalar) writeonly buffer VplGlossBlock { VplGloss vplGloss[]; };
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { EmissionPush push; };

// The path that holds vertex number `vertex`: the last one whose offset is not beyond it.
uint pathOfVertex(uint vertex) {
    uint low = 0u;
    uint high = push.pathCount - 1u;
    while (low < high) {
        const uint middle = (low + high + 1u) / 2u;
        if (pathOffsets[middle] <= vertex) low = middle;
        else high = middle - 1u;
    }
    return low;
}

// floor((a b + c) / d) where the product may need 64 bits and the result is below 2^20: a quotient in floats is off by
// one at most, and the low words tell which way.
uint dividedProduct(uint a, uint b, uint c, uint d) {
    const float estimate = (float(a) * float(b) + float(c)) / float(d);
    const uint quotient = uint(estimate);
    const int remainder = int(a * b + c - quotient * d);  // wraps to the true one, which is small
    return remainder < 0 ? quotient - 1u : remainder >= int(d) ? quotient + 1u : quotient;
}

LightData darkVpl() {
    return LightData(vec3(0.0), 0.0, vec3(0.0, 0.0, 1.0), kLightSurface, vec3(0.0), 0.0, 1.0, 0u, 0u, 0u);
}

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= push.paddedVplCount) return;
    const uint vertexCount = pathOffsets[push.pathCount];
    const uint taken = min(vertexCount, push.vplCount);
    LightData vpl = darkVpl();
    VplGloss gloss = VplGloss(vec3(0.0), 1.0, vec3(0.0, 0.0, 1.0), 0.0, vec3(0.0, 0.0, 1.0), 0.0, vec3(0.0), 0.0,
                              vec3(0.0), 0.0);
    if (i < taken) {
        uint vertex = i;
        if (vertexCount > push.vplCount) {
            const uint key = hashCombine(hashCombine(hashCombine(frame.seed, frame.frame), push.firstPath), i);
            vertex = dividedProduct(i, vertexCount, sampleInteger(key, vertexCount), push.vplCount);
        }
        const uint path = pathOfVertex(vertex);
        const uint place = (vertex - pathOffsets[path]) * push.pathCount + path;
        const float weight = float(vertexCount) / float(taken);
        vpl = pathVertices[place];
        vpl.intensity *= weight;
        if (kGlossy) {
            gloss = pathGloss[place];
            gloss.flux *= weight;
        }
    }
    vpls[push.firstVpl + i] = vpl;
    if (kGlossy) vplGloss[push.firstVpl + i] = gloss;
    if (i == 0u) atomicAdd(status.vplsShaded, taken);
}
