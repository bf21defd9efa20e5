#ifndef MANYLIGHT_SHARED_TRACE_RAYS_H
#define MANYLIGHT_SHARED_TRACE_RAYS_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

MANYLIGHT_CONSTANT(uint, kTraceRaysGroupSize, 64u);
// Devices need not take more than 65,535 workgroups at once.
MANYLIGHT_CONSTANT(uint, kMaxRaysPerDispatch, 65535u * kTraceRaysGroupSize);

// The answer to a RayQuery for the closest hit. For any hit it is one uint: 1 if there is one, 0 otherwise.
struct RayHit {
    float t;            // the query's tMax if there is no hit; -1 for a zero direction
    uint triangle;      // in the BVH's leaf order; kNoHit: none
    vec2 barycentrics;  // weights of the second and third corner
};

struct TraceRaysPush {
    uint firstRay;
    uint endRay;
};

MANYLIGHT_SHARED_END
#endif
