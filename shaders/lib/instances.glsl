// The upper of two levels: instances put meshes into the scene, each with a BVH of its own. A ray is taken into the
// frame of every mesh it may meet, where t means what it means in the scene. Tests compile it as C++ too.
#ifndef MANYLIGHT_LIB_INSTANCES
#define MANYLIGHT_LIB_INSTANCES
#include "shaders/shared/instance.h"

#ifndef __cplusplus
layout(set = 0, binding = kBindingInstances, rgba32ui) readonly uniform uimageBuffer instanceTexels;
#endif

uvec4 instanceTexel(uint instance, int texel) { return imageLoad(instanceTexels, int(instance) * kTexelsPerInstance + texel); }

uint bvhRootOf(uint instance) { return instanceTexel(instance, 0).w; }
uint numberOffsetOf(uint instance) { return instanceTexel(instance, 1).w; }
uint firstNumberOf(uint instance) { return instanceTexel(instance, 2).w; }
uint instanceOfLeaf(uint leaf) { return instanceTexel(leaf, 3).w; }

// The instance that was asked for last: the next question is mostly about it again.
uint lastInstance = 0u;
uint lastFirstNumber = 0u;
uint lastNumberCount = 0u;

void rememberInstance(uint instance) {
    lastInstance = instance;
    lastFirstNumber = firstNumberOf(instance);
    lastNumberCount = firstNumberOf(instance + 1u) - lastFirstNumber;
}

vec3 floatsOf(uvec4 texel) { return vec3(uintBitsToFloat(texel.x), uintBitsToFloat(texel.y), uintBitsToFloat(texel.z)); }

// The centre first: what is far from it loses no more than it would have among the scene's own triangles.
TraversalRay rayInMesh(uint instance, vec3 origin, vec3 direction) {
    const vec3 row0 = floatsOf(instanceTexel(instance, 0));
    const vec3 row1 = floatsOf(instanceTexel(instance, 1));
    const vec3 row2 = floatsOf(instanceTexel(instance, 2));
    const vec3 start = origin - floatsOf(instanceTexel(instance, 3));
    return makeTraversalRay(vec3(dot(row0, start), dot(row1, start), dot(row2, start)),
                            vec3(dot(row0, direction), dot(row1, direction), dot(row2, direction)));
}

#ifndef MANYLIGHT_RAY_QUERY
// occluded() of bvh.glsl, over instances.
bool occludedByInstances(vec3 origin, vec3 direction, float tEnd, uint number) {
    const TraversalRay ray = makeTraversalRay(origin, direction);
    beginTraversal(0);
    uint siblings = 1u;
    uint leafSlots = 0u;
    uint firstLeaf = 0u;
    bool isHit = false;
    bool isDone = false;
    while (!isDone) {
        bool descends = !hasSlots(leafSlots);
        while (descends) {
            const uint bit = lowestSlotBit(siblings);
            const NodeVisit visit = visitNode(ray, (siblings >> 8) + slotOfBit(bit), tEnd);
            leafSlots = visit.leafSlots;
            firstLeaf = visit.firstTriangle;
            siblings = nextInSlotOrder((visit.firstChild << 8) | visit.innerSlots, siblings - bit, false);
            descends = hasSlots(siblings) && !hasSlots(leafSlots);
        }
        const bool meetsOne = hasSlots(leafSlots);
        const uint instance = instanceOfLeaf(lowestLeaf(leafSlots, firstLeaf).first);
        const int top = bvhTop;
        isHit = occludedInTree(rayInMesh(instance, origin, direction), meetsOne ? tEnd : -1.0f,
                               number + numberOffsetOf(instance), bvhRootOf(instance), top);
        bvhTop = top;
        leafSlots -= lowestSlotBit(leafSlots);
        isDone = isHit || !hasSlots(siblings | leafSlots);
    }
    bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || !isDone;
    return isHit;
}

// closestHit() of bvh.glsl, over instances. `best` is what has been found before, nothing at tMax.
Hit closestHitOfInstances(vec3 origin, vec3 direction, Hit best, float tMax, uint number) {
    const TraversalRay ray = makeTraversalRay(origin, direction);
    beginTraversal(0);
    uint node = 0u;
    bool hasNode = true;
    uint siblings = 0u;
    uint leafSlots = 0u;
    uint firstLeaf = 0u;
    uint bestInstance = 0u;
    bool isDone = false;
    while (!isDone) {
        bool descends = hasNode && !hasSlots(leafSlots);
        while (descends) {
            const NodeVisit visit = visitNode(ray, node, best.t);
            leafSlots = visit.leafSlots;
            firstLeaf = visit.firstTriangle;
            const bool hasInner = hasSlots(visit.innerSlots);
            const NearestFirst children = nearestFirst(visit);
            hasNode = hasInner || queueLength(siblings) != 0u;
            node = hasInner ? children.nearest : queueFront(siblings);
            siblings = nextInOrderOfDistance(children.others, hasInner, siblings, 0u);
            descends = hasNode && !hasSlots(leafSlots);
        }
        const bool meetsOne = hasSlots(leafSlots);
        const uint instance = instanceOfLeaf(lowestLeaf(leafSlots, firstLeaf).first);
        const int top = bvhTop;
        const uint before = best.triangle;
        const uint offset = numberOffsetOf(instance);
        best = closestHitInTree(rayInMesh(instance, origin, direction), meetsOne, best, tMax, number + offset,
                                bvhRootOf(instance), offset, top);
        bvhTop = top;
        bestInstance = best.triangle != before ? instance : bestInstance;
        leafSlots -= lowestSlotBit(leafSlots);
        isDone = !hasNode && !hasSlots(leafSlots);
    }
    bvhLoopBudgetExceeded = bvhLoopBudgetExceeded || !isDone;
    rememberInstance(bestInstance);
    return best;
}
#endif

#endif
