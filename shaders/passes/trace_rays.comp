// Answers a list of ray queries, one invocation each.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#extension GL_EXT_scalar_block_layout : require
#include "shaders/lib/bvh.glsl"
#include "shaders/shared/lights.h"
#include "shaders/shared/ray.h"
#include "shaders/shared/trace_rays.h"

layout(constant_id = 0) const bool kAnyHit = false;

// Queries know no materials: every triangle is opaque.
bool letsThrough(uint triangle, vec2 barycentrics, uint ray) { return false; }

layout(local_size_x = kTraceRaysGroupSize) in;
layout(set = 0, binding = kBindingRayQueries, rgba32f) readonly uniform imageBuffer queries;  // two texels per RayQuery
// Which of the two views of the answers is used is up to kAnyHit.
layout(set = 0, binding = kBindingRayAnswers, scalar) writeonly buffer HitBlock { RayHit hits[]; };
layout(set = 0, binding = kBindingRayAnswers, scalar) writeonly buffer OccludedBlock { uint occludedFlags[]; };
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { TraceRaysPush push; };

void main() {
    const uint i = push.firstRay + gl_GlobalInvocationID.x;
    if (i >= push.endRay) return;
    const vec4 start = imageLoad(queries, int(2u * i));  // and tMax
    const vec3 direction = imageLoad(queries, int(2u * i + 1u)).xyz;
    if (kAnyHit) {
        occludedFlags[i] = occluded(start.xyz, direction, start.w) ? 1u : 0u;
    } else {
        const Hit hit = closestHit(start.xyz, direction, start.w);
        hits[i] = RayHit(hit.t, hit.triangle, hit.barycentrics);
    }
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);
}
