// Every ray goes through here. Needs the buffers that engine/accel builds, bound as bindings.h says. Tests compile it
// as C++ too, with their own imageLoad(). With MANYLIGHT_RAY_QUERY the device finds the triangles, see ray_query.glsl.
#ifndef MANYLIGHT_LIB_BVH
#define MANYLIGHT_LIB_BVH
#include "shaders/shared/bindings.h"
#include "shaders/shared/bvh_ray.h"
#include "shaders/shared/sobol.h"
#include "shaders/shared/workgroups.h"

#ifndef __cplusplus
#ifndef MANYLIGHT_RAY_QUERY
layout(set = 0, binding = kBindingBvhNodes, rgba32ui) readonly uniform uimageBuffer bvhNodes;
#endif
layout(set = 0, binding = kBindingTriangles, rgba32ui) readonly uniform uimageBuffer bvhTriangles;

// Whether any-hit queries keep their stack in registers, as SIMD code for CPUs likes it: a store that only some lanes
// make is a branch for each lane there (10 % of the time for incoherent rays on lavapipe).
layout(constant_id = kConstantStackInRegisters) const bool kBvhStackInRegisters = true;
// Likewise of closest-hit queries: how many words of it are registers, enough for the tree, or 0.
layout(constant_id = kConstantClosestRegisters) const uint kBvhClosestRegisters = 0u;

// An invocation at a leaf waits until its subgroup's others are at leaves too, but for no more nodes than these.
layout(constant_id = kConstantNodesAnyHit) const int kMostNodesAny = 12;
layout(constant_id = kConstantNodesClosestHit) const int kMostNodesClosest = 8;

// Left out by ScenePlan where every material is opaque.
layout(constant_id = 3) const bool kAlphaTested = false;

// 0: every triangle is in the scene's frame. 1: meshes are, where instances put them. 2: some instances stretch theirs.
layout(constant_id = 9) const uint kInstanced = 0u;
#endif

// Does that ray pass through the triangle stored there? Defined by who knows materials; not asked unless kAlphaTested.
bool letsThrough(uint place, vec2 barycentrics, uint ray);

// A number by which a ray meets a translucent surface always in the same way.
uint numberOfRay(vec3 origin, vec3 direction) {
    const uint start = hashCombine(hashCombine(floatBitsToUint(origin.x), floatBitsToUint(origin.y)), floatBitsToUint(origin.z));
    const uint end = hashCombine(hashCombine(floatBitsToUint(direction.x), floatBitsToUint(direction.y)), floatBitsToUint(direction.z));
    return hashCombine(start, end);
}

struct Hit {
    float t;
    uint triangle;      // in leaf order, through all instances; kNoHit: none
    vec2 barycentrics;  // weights of the second and third corner
};

// A driver may end loops after a number of iterations (lavapipe: 65,535 per invocation, without a word). Set when a
// loop of a traversal ended though its condition held: the answer is worth nothing, and the pass must say so.
bool bvhLoopBudgetExceeded = false;

#ifndef MANYLIGHT_RAY_QUERY
// Siblings put aside, at most those of one node per level; what a word means is up to the query. Below the last there
// is an empty one. Of two levels, the lower one's come above the upper one's.
const int kBvhStackWords = kInstanced == 0u ? kBvhStackSize : 2 * kBvhStackSize;
uint bvhStack[kBvhStackWords];
int bvhTop = 0;

// The same in registers, the last put aside first. The fourth four are for closest-hit queries: see kBvhRegisterStackSize.
uvec4 bvhFirstFour = uvec4(0u);
uvec4 bvhSecondFour = uvec4(0u);
uvec4 bvhThirdFour = uvec4(0u);
uvec4 bvhFourthFour = uvec4(0u);

void beginTraversal(int top) {
    bvhStack[top] = 0u;
    bvhTop = top + 1;
    bvhFirstFour = uvec4(0u);
    bvhSecondFour = uvec4(0u);
    bvhThirdFour = uvec4(0u);
    bvhFourthFour = uvec4(0u);
}

// Puts aside, or takes back what was put aside last, to go on with it instead of `next`. Reads and writes without a
// condition: branches cost SIMD lanes more.
uint exchangeInMemory(uint siblings, bool pushes, bool pops, uint next) {
    bvhStack[bvhTop] = siblings;
    const uint last = bvhStack[max(bvhTop - 1, 0)];
    bvhTop += pushes ? 1 : (pops ? -1 : 0);
    return pops ? last : next;
}

uint exchangeInRegisters(uint siblings, bool pushes, bool pops, uint next, bool usesFourth) {
    uvec4 a = bvhFirstFour;
    uvec4 b = bvhSecondFour;
    uvec4 c = bvhThirdFour;
    uvec4 d = usesFourth ? bvhFourthFour : uvec4(0u);
    // Before the registers move: what is read afterwards would be copied in every step.
    const uint last = pops ? a.x : next;
    a = pops ? uvec4(a.y, a.z, a.w, b.x) : a;
    b = pops ? uvec4(b.y, b.z, b.w, c.x) : b;
    c = pops ? uvec4(c.y, c.z, c.w, d.x) : c;
    d = pops ? uvec4(d.y, d.z, d.w, 0u) : d;
    bvhFourthFour = pushes ? uvec4(c.w, d.x, d.y, d.z) : d;
    bvhThirdFour = pushes ? uvec4(b.w, c.x, c.y, c.z) : c;
    bvhSecondFour = pushes ? uvec4(a.w, b.x, b.y, b.z) : b;
    bvhFirstFour = pushes ? uvec4(siblings, a.x, a.y, a.z) : a;
    return last;
}

NodeVisit visitNode(TraversalRay ray, uint node, float tMax) {
    const int texel = int(node) * kBvhTexelsPerNode;
    return visitNode(ray, imageLoad(bvhNodes, texel), imageLoad(bvhNodes, texel + 1), imageLoad(bvhNodes, texel + 2),
                     tMax);
}
#endif

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

#ifndef MANYLIGHT_RAY_QUERY
// Where to go on after a visit, given the inner children that the ray meets and the visited node's own siblings: down,
// with the siblings put aside; along; or up.
uint nextInSlotOrder(uint children, uint siblings, bool inRegisters) {
    const bool pushes = hasSlots(children) && hasSlots(siblings);
    const bool pops = !hasSlots(children) && !hasSlots(siblings);
    const uint next = hasSlots(children) ? children : siblings;
    return inRegisters ? exchangeInRegisters(siblings, pushes, pops, next, false)
                       : exchangeInMemory(siblings, pushes, pops, next);
}

// Loops over nodes end where it is known that they do: an answer kept for the beginning of the next step would cost SIMD lanes
// more. They have a second way out at their beginning, and must: out of a loop that ends at its end alone, Mesa 22.3's
// lavapipe lets a lane take what other lanes have assigned after it left.

// Does the ray meet a triangle below `root` at t in (0, tEnd)?
// `siblings`: node of the first inner child * 256 | slots still to visit, which is in the order of slots.
bool occludedInTree(TraversalRay ray, float tEnd, uint number, uint root, int top) {
    beginTraversal(top);
    uint siblings = (root << 8) | 1u;
    uint leafSlots = 0u;
    uint firstTriangle = 0u;
    bool isHit = false;
    bool isDone = false;
    while (!isDone) {
        const int most = hasSlots(leafSlots) ? 0 : kMostNodesAny;
        for (int count = 0; count < most; ++count) {
            const uint bit = lowestSlotBit(siblings);
            const NodeVisit visit = visitNode(ray, (siblings >> 8) + slotOfBit(bit), tEnd);
            leafSlots = visit.leafSlots;
            firstTriangle = visit.firstTriangle;
            siblings = nextInSlotOrder((visit.firstChild << 8) | visit.innerSlots, siblings - bit, kBvhStackInRegisters);
            if (!hasSlots(siblings) || hasSlots(leafSlots)) break;
        }
        const LeafTriangles triangles = lowestLeaf(leafSlots, firstTriangle);
        const TriangleHit a = testTriangle(ray, triangles.first, tEnd);
        const TriangleHit b = testTriangle(ray, triangles.second, tEnd);
        bool hitsFirst = hasSlots(leafSlots) && a.isHit && a.t < tEnd;
        bool hitsSecond = hasSlots(leafSlots) && b.isHit && b.t < tEnd;
        if (kAlphaTested) {
            hitsFirst = hitsFirst && !letsThrough(triangles.first, a.barycentrics, number);
            hitsSecond = hitsSecond && !letsThrough(triangles.second, b.barycentrics, number);
        }
        isHit = hitsFirst || hitsSecond;
        leafSlots -= lowestSlotBit(leafSlots);
        isDone = isHit || !hasSlots(siblings | leafSlots);
    }
    bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || !isDone;
    return isHit;
}

Hit nearer(Hit best, TriangleHit hit, uint triangle, float tMax) {
    const bool isBetter = hit.isHit && hit.t < tMax && (hit.t < best.t || triangle < best.triangle);
    best.t = isBetter ? hit.t : best.t;
    best.triangle = isBetter ? triangle : best.triangle;
    best.barycentrics = isBetter ? hit.barycentrics : best.barycentrics;
    return best;
}

// Where to go on after a visit: the nearest of the inner children that the ray meets, if there is any, or the first of
// `siblings`. Whose turn it is after that: the other children, the siblings left, or those put aside last.
uint nextInOrderOfDistance(uint others, bool hasInner, uint siblings, uint registers) {
    const uint left = hasInner ? siblings : withoutFront(siblings);
    const bool goesDown = hasInner && queueLength(others) != 0u;
    const bool goesUp = !hasInner && queueLength(left) == 0u;
    const uint next = goesDown ? others : left;
    return registers > 0u ? exchangeInRegisters(siblings, goesDown, goesUp, next, registers > kBvhShortStackSize)
                          : exchangeInMemory(siblings, goesDown, goesUp, next);
}

// The nearer of `best` and what is below `root`, if that is to be visited at all. `numberOffset` is added to what
// triangles are called.
// `siblings` is a queue, see bvh_ray.h, to be visited after `node`.
Hit closestHitInTree(TraversalRay ray, bool visitsRoot, Hit best, float tMax, uint number, uint root, uint numberOffset,
                     int top) {
    beginTraversal(top);
    uint node = root;
    bool hasNode = visitsRoot;
    uint siblings = 0u;
    uint leafSlots = 0u;
    uint firstTriangle = 0u;
    bool isDone = false;
    while (!isDone) {
        const int most = hasNode && !hasSlots(leafSlots) ? kMostNodesClosest : 0;
        for (int count = 0; count < most; ++count) {
            const NodeVisit visit = visitNode(ray, node, best.t);
            leafSlots = visit.leafSlots;
            firstTriangle = visit.firstTriangle;
            const bool hasInner = hasSlots(visit.innerSlots);
            const NearestFirst children = nearestFirst(visit);
            hasNode = hasInner || queueLength(siblings) != 0u;
            node = hasInner ? children.nearest : queueFront(siblings);
            siblings = nextInOrderOfDistance(children.others, hasInner, siblings, kBvhClosestRegisters);
            if (!hasNode || hasSlots(leafSlots)) break;
        }
        const LeafTriangles triangles = lowestLeaf(leafSlots, firstTriangle);
        TriangleHit a = testTriangle(ray, triangles.first, best.t);
        TriangleHit b = testTriangle(ray, triangles.second, best.t);
        a.isHit = a.isHit && hasSlots(leafSlots);
        b.isHit = b.isHit && hasSlots(leafSlots);
        if (kAlphaTested) {
            a.isHit = a.isHit && !letsThrough(triangles.first, a.barycentrics, number);
            b.isHit = b.isHit && !letsThrough(triangles.second, b.barycentrics, number);
        }
        best = nearer(nearer(best, a, triangles.first + numberOffset, tMax), b, triangles.second + numberOffset, tMax);
        leafSlots -= lowestSlotBit(leafSlots);
        isDone = !hasNode && !hasSlots(leafSlots);
    }
    bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || !isDone;
    return best;
}
#endif

#include "shaders/lib/instances.glsl"

#ifdef MANYLIGHT_RAY_QUERY
#include "shaders/lib/ray_query.glsl"
#else
// Is there a triangle at t in (0, tMax)? A zero direction meets nothing.
bool occluded(vec3 origin, vec3 direction, float tMax) {
    const float tEnd = direction == vec3(0.0f) ? -1.0f : tMax;
    const uint number = kAlphaTested ? numberOfRay(origin, direction) : 0u;
    if (kInstanced != 0u) return occludedByInstances(origin, direction, tEnd, number);
    return occludedInTree(makeTraversalRay(origin, direction), tEnd, number, 0u, 0);
}

// The nearest triangle at t in (0, tMax); of several at the same t the first in leaf order.
Hit closestHit(vec3 origin, vec3 direction, float tMax) {
    const uint number = kAlphaTested ? numberOfRay(origin, direction) : 0u;
    Hit best;
    best.t = direction == vec3(0.0f) ? -1.0f : tMax;
    best.triangle = kNoHit;
    best.barycentrics = vec2(0.0f);
    if (kInstanced != 0u) return closestHitOfInstances(origin, direction, best, tMax, number);
    return closestHitInTree(makeTraversalRay(origin, direction), true, best, tMax, number, 0u, 0u, 0);
}
#endif

#endif
