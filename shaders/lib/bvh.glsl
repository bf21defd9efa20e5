// Every ray goes through here. Needs the buffers that engine/accel builds, bound as bindings.h says. Tests compile it
// as C++ too, with their own imageLoad().
#ifndef MANYLIGHT_LIB_BVH
#define MANYLIGHT_LIB_BVH
#include "shaders/shared/bindings.h"
#include "shaders/shared/bvh_ray.h"

#ifndef __cplusplus
#extension GL_KHR_shader_subgroup_ballot : require
layout(set = 0, binding = kBindingBvhNodes, rgba32ui) readonly uniform uimageBuffer bvhNodes;
layout(set = 0, binding = kBindingTriangles, rgba32ui) readonly uniform uimageBuffer bvhTriangles;

uint countInvocations(bool condition) { return subgroupBallotBitCount(subgroupBallot(condition)); }
#endif

struct Hit {
    float t;
    uint triangle;      // in leaf order; kNoHit: none
    vec2 barycentrics;  // weights of the second and third corner
};

// A driver may end loops after a number of iterations (lavapipe: 65,535 per invocation, without a word). Set when a
// loop of a traversal ended though its condition held: the answer is worth nothing, and the pass must say so.
bool bvhLoopBudgetExceeded = false;

// The children put aside. The last one is in a register, so that the next node need not wait for memory; those below
// it are in bvhStack[0] to bvhStack[bvhTop - 1]. At the bottom is kBvhDone, however often it is taken.
uint bvhStack[kBvhStackSize];
uint bvhTopEntry = kBvhDone;
int bvhTop = 0;

void beginTraversal() {
    bvhStack[0] = kBvhDone;
    bvhTopEntry = kBvhDone;
    bvhTop = 0;
}

// The last child put aside, if `pops`; otherwise `next`.
uint popNode(uint next, bool pops) {
    const uint popped = pops ? bvhTopEntry : next;
    const int top = max(bvhTop - 1, 0);
    bvhTopEntry = pops ? bvhStack[top] : bvhTopEntry;
    bvhTop = pops ? top : bvhTop;
    return popped;
}

// Picks the next of a visited node's children, puts the other one aside, or pops; nothing of it if `next` is no node
// but a leaf. Without branches, which would cost SIMD lanes more than the extra store.
uint nextAfter(uint next, NodeVisit visit, bool rightFirst) {
    const bool isInner = (next & kBvhLeaf) == 0u;
    const bool pushes = isInner && visit.hitsLeft && visit.hitsRight;
    const bool descends = isInner && (visit.hitsLeft || visit.hitsRight);
    const bool takesRight = visit.hitsRight && (rightFirst || !visit.hitsLeft);
    bvhStack[bvhTop] = bvhTopEntry;
    const uint after = popNode(next, isInner && !descends);
    bvhTopEntry = pushes ? (rightFirst ? visit.left : visit.right) : bvhTopEntry;
    bvhTop = pushes ? bvhTop + 1 : bvhTop;
    return descends ? (takesRight ? visit.right : visit.left) : after;
}

// An invocation that waits at a leaf visits the root meanwhile, to no effect.
NodeVisit visitChildren(TraversalRay ray, uint next, float tMax) {
    const uint node = (next & kBvhLeaf) == 0u ? next : 0u;
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

// An invocation at a leaf waits for its subgroup's others only while most of them have nodes to visit.
bool mostDescend(uint next, uint rayCount) { return 2u * countInvocations((next & kBvhLeaf) == 0u) > rayCount; }

// Is there a triangle at t in (0, tMax)? A zero direction meets nothing.
bool occluded(vec3 origin, vec3 direction, float tMax) {
    const TraversalRay ray = makeTraversalRay(origin, direction);
    const float tEnd = direction == vec3(0.0f) ? -1.0f : tMax;
    bool isHit = false;
    beginTraversal();
    uint next = 0u;
    while (next != kBvhDone) {
        const uint rayCount = countInvocations(true);
        bool descends = true;
        while (descends) {
            const NodeVisit visit = visitChildren(ray, next, tEnd);
            next = nextAfter(next, visit, isRightLikelier(visit));
            descends = mostDescend(next, rayCount);
        }
        bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || descends;
        // A leaf has one triangle or two; a single one is tested twice.
        const bool isLeaf = (next & kBvhLeaf) != 0u;
        const uint count = isLeaf ? next & 15u : 0u;
        const uint first = isLeaf ? (next & ~kBvhLeaf) >> 4 : 0u;
        const TriangleHit a = testTriangle(ray, first, tEnd);
        const TriangleHit b = testTriangle(ray, first + (count >> 1), tEnd);
        isHit = count != 0u && ((a.isHit && a.t < tEnd) || (b.isHit && b.t < tEnd));
        const uint popped = popNode(next, isLeaf);
        next = isHit ? kBvhDone : popped;
    }
    bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || next != kBvhDone;
    return isHit;
}

Hit nearer(Hit best, TriangleHit hit, uint triangle, float tMax) {
    const bool isBetter = hit.isHit && hit.t < tMax && (hit.t < best.t || triangle < best.triangle);
    best.t = isBetter ? hit.t : best.t;
    best.triangle = isBetter ? triangle : best.triangle;
    best.barycentrics = isBetter ? hit.barycentrics : best.barycentrics;
    return best;
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
        const uint rayCount = countInvocations(true);
        bool descends = true;
        while (descends) {
            const NodeVisit visit = visitChildren(ray, next, best.t);
            next = nextAfter(next, visit, isRightNearer(visit));
            descends = mostDescend(next, rayCount);
        }
        bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || descends;
        const bool isLeaf = (next & kBvhLeaf) != 0u;
        const uint count = isLeaf ? next & 15u : 0u;
        const uint first = isLeaf ? (next & ~kBvhLeaf) >> 4 : 0u;
        const uint second = first + (count >> 1);
        TriangleHit a = testTriangle(ray, first, best.t);
        TriangleHit b = testTriangle(ray, second, best.t);
        a.isHit = a.isHit && count != 0u;
        b.isHit = b.isHit && count != 0u;
        best = nearer(nearer(best, a, first, tMax), b, second, tMax);
        next = popNode(next, isLeaf);
    }
    bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || next != kBvhDone;
    return best;
}

#endif
