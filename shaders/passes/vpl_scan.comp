// Exclusive prefix sum of the paths' vertex counts, by one workgroup; entry [pathCount] becomes the total.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/vpl_emission.h"

layout(local_size_x = kScanGroupSize) in;
layout(set = 0, binding = kBindingPathOffsets, scalar) buffer PathBlock { uint pathOffsets[]; };
layout(push_constant, scalar) uniform Push { EmissionPush push; };

shared uint partial[kScanGroupSize];

void main() {
    const uint lane = gl_LocalInvocationID.x;
    const uint perLane = (push.pathCount + kScanGroupSize - 1u) / kScanGroupSize;
    const uint first = min(lane * perLane, push.pathCount);
    const uint end = min(first + perLane, push.pathCount);

    // Each lane sums its stretch, the group scans the sums.
    uint sum = 0u;
    for (uint i = first; i < end; ++i) sum += pathOffsets[i];
    partial[lane] = sum;
    barrier();
    for (uint step = 1u; step < kScanGroupSize; step *= 2u) {
        const uint left = lane >= step ? partial[lane - step] : 0u;
        barrier();
        partial[lane] += left;
        barrier();
    }

    uint offset = partial[lane] - sum;
    for (uint i = first; i < end; ++i) {
        const uint count = pathOffsets[i];
        pathOffsets[i] = offset;
        offset += count;
    }
    if (lane == kScanGroupSize - 1u) pathOffsets[push.pathCount] = partial[lane];
}
