// Every ray goes through here. Needs the buffers that engine/accel builds, bound as bindings.h says. Tests compile it
// as C++ too, with their own imageLoad().
#ifndef MANYLIGHT_LIB_BVH
#define MANYLIGHT_LIB_BVH
#include "shaders/shared/bindings.h"
#include "shaders/shared/bvh_ray.h"

#ifndef __cplusplus
layout(set = 0, binding = kBindingBvhNodes, rgba32ui) readonly uniform uimageBuffer bvhNodes;
layout(set = 0, binding = kBindingTriangles, rgba32ui) readonly uniform uimageBuffer bvhTriangles;
#endif

struct Hit {
    float t;
    uint triangle;      // in leaf order; kNoHit: none
    vec2 barycentrics;  // weights of the second and third corner
};

// A driver may end loops after a number of iterations (lavapipe: 65,535 per invocation, without a word). Set when a
// loop of a traversal ended though its condition held: the answer is worth nothing, and the pass must say so.
bool bvhLoopBudgetExceeded = false;

// The children put aside, with kBvhDone at the bottom.
uint bvhStack[kBvhStackSize];
int bvhTop = 0;

void beginTraversal() {
    bvhStack[0] = kBvhDone;
    bvhTop = 0;
}

uint popNode() {
    const uint next = bvhStack[max(bvhTop, 0)];
    --bvhTop;
    return next;
}

// Picks the next of a visited node's children, puts the other one aside, or pops: without branches, which would cost
// SIMD lanes more than the extra store.
uint nextAfter(NodeVisit visit, bool rightFirst) {
    const bool hitsBoth = visit.hitsLeft && visit.hitsRight;
    const bool hitsAny = visit.hitsLeft || visit.hitsRight;
    bvhStack[bvhTop + 1] = rightFirst ? visit.left : visit.right;
    const uint popped = bvhStack[bvhTop];
    const bool takesRight = visit.hitsRight && (rightFirst || !visit.hitsLeft);
    bvhTop += hitsBoth ? 1 : (hitsAny ? 0 : -1);
    return hitsAny ? (takesRight ? visit.right : visit.left) : popped;
}

NodeVisit visitChildren(TraversalRay ray, uint node, float tMax) {
    const uvec4 a = imageLoad(bvhNodes, int(node) * 2);
    const uvec4 b = imageLoad(bvhNodes, int(node) * 2 + 1);
    return visitNode(ray, node, a, b, tMax);
}

// `corner` is 0, 1 or 2. The fourth component is the packed normal, see packing.h.
uvec4 triangleCorner(uint triangle, int corner) {
    return imageLoad(bvhTriangles, int(triangle + triangle + triangle) + corner);
}

vec3 cornerPosition(uvec4 corner) {
    return vec3(uintBitsToFloat(corner.x), uintBitsToFloat(corner.y), uintBitsToFloat(corner.z));
}

TriangleHit testTriangle(TraversalRay ray, uint triangle, float tMax) {
    return intersectTriangle(ray, cornerPosition(triangleCorner(triangle, 0)),
                             cornerPosition(triangleCorner(triangle, 1)), cornerPosition(triangleCorner(triangle, 2)),
                             tMax);
}

// Is there a triangle at t in (0, tMax)? A zero direction meets nothing.
bool occluded(vec3 origin, vec3 direction, float tMax) {
    const TraversalRay ray = makeTraversalRay(origin, direction);
    const float tEnd = direction == vec3(0.0f) ? -1.0f : tMax;
    bool isHit = false;
    beginTraversal();
    uint next = 0u;
    while (next != kBvhDone) {
        while ((next & kBvhLeaf) == 0u) {
            const NodeVisit visit = visitChildren(ray, next, tEnd);
            next = nextAfter(visit, isRightLikelier(visit));
        }
        bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || (next & kBvhLeaf) == 0u;
        uint triangle = (next & ~kBvhLeaf) >> 4;
        const uint end = triangle + (next & 15u);
        while (triangle < end) {
            const TriangleHit hit = testTriangle(ray, triangle, tEnd);
            isHit = isHit || (hit.isHit && hit.t < tEnd);
            triangle = isHit ? end : triangle + 1u;
        }
        bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || triangle < end;
        const uint popped = popNode();
        next = isHit ? kBvhDone : popped;
    }
    bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || next != kBvhDone;
    return isHit;
}

// The nearest triangle at t in (0, tMax); of several at the same t the first in leaf order.
Hit closestHit(vec3 origin, vec3 direction, float tMax) {
    const TraversalRay ray = makeTraversalRay(origin, direction);
    Hit best;
    best.t = direction == vec3(0.0f) ? -1.0f : tMax;
    best.triangle = kNoHit;
    best.barycentrics = vec2(0.0f);
    beginTraversal();
    uint next = 0u;
    while (next != kBvhDone) {
        while ((next & kBvhLeaf) == 0u) {
            const NodeVisit visit = visitChildren(ray, next, best.t);
            next = nextAfter(visit, isRightNearer(visit));
        }
        bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || (next & kBvhLeaf) == 0u;
        uint triangle = (next & ~kBvhLeaf) >> 4;
        const uint end = triangle + (next & 15u);
        while (triangle < end) {
            const TriangleHit hit = testTriangle(ray, triangle, best.t);
            const bool isBetter = hit.isHit && hit.t < tMax && (hit.t < best.t || triangle < best.triangle);
            best.t = isBetter ? hit.t : best.t;
            best.triangle = isBetter ? triangle : best.triangle;
            best.barycentrics = isBetter ? hit.barycentrics : best.barycentrics;
            ++triangle;
        }
        bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || triangle < end;
        next = popNode();
    }
    bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || next != kBvhDone;
    return best;
}

#endif
