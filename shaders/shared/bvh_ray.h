// The arithmetic of a ray's way through the BVH: slab test of Kay and Kajiya (1986), watertight triangle test of Woop,
// Benthin and Wald (2013). Both languages compile it, so that it is tested without a device.
#ifndef MANYLIGHT_SHARED_BVH_RAY_H
#define MANYLIGHT_SHARED_BVH_RAY_H
#include "shaders/shared/bvh.h"

MANYLIGHT_SHARED_BEGIN
#ifdef __cplusplus
using glm::abs;
using glm::bvec4;
using glm::floatBitsToInt;
using glm::ivec4;
using glm::lessThanEqual;
using glm::max;
using glm::min;
using glm::uintBitsToFloat;
#endif

// A ray prepared for both tests.
struct TraversalRay {
    vec3 origin;
    vec3 inverseDirection;
    bool isNegativeX;  // the upper planes of x are the near ones
    bool isNegativeY;
    bool isNegativeZ;
    bool isAlongX;  // the largest component of the direction is x
    bool isAlongY;  // or y; z otherwise
    vec3 shear;     // the other two components over the largest, and its inverse
};

// A node's children as a ray meets them.
struct NodeVisit {
    uint innerSlots;  // bit per slot with an inner child that the ray meets
    uint leafSlots;   // bits 0-3: likewise with a leaf. Bits 4-6: slots before the leaves of one triangle
    uint firstChild;
    uint firstTriangle;  // as in BvhNode
    ivec4 entry;         // bits of the t where the ray enters each box, not negative
};

struct TriangleHit {
    bool isHit;
    float t;
    vec2 barycentrics;  // weights of the second and third corner
};

// A component too small to divide by becomes 1e-20 with its sign: no infinity meets a zero.
MANYLIGHT_FUNCTION float clampedInverse(float d) {
    return 1.0f / (abs(d) < 1e-20f ? (d < 0.0f ? -1e-20f : 1e-20f) : d);
}

// The axis of the largest component becomes z, without mirroring.
MANYLIGHT_FUNCTION vec3 permuted(vec3 v, bool isAlongX, bool isAlongY) {
    return isAlongX ? vec3(v.y, v.z, v.x) : (isAlongY ? vec3(v.z, v.x, v.y) : v);
}

MANYLIGHT_FUNCTION TraversalRay makeTraversalRay(vec3 origin, vec3 direction) {
    TraversalRay ray;
    ray.origin = origin;
    ray.inverseDirection = vec3(clampedInverse(direction.x), clampedInverse(direction.y), clampedInverse(direction.z));
    // From the reciprocal, not from the direction: -0 must not choose another octant than its reciprocal.
    ray.isNegativeX = ray.inverseDirection.x < 0.0f;
    ray.isNegativeY = ray.inverseDirection.y < 0.0f;
    ray.isNegativeZ = ray.inverseDirection.z < 0.0f;
    ray.isAlongX = abs(direction.x) > abs(direction.y) && abs(direction.x) > abs(direction.z);
    ray.isAlongY = !ray.isAlongX && abs(direction.y) > abs(direction.z);
    const vec3 turned = permuted(direction, ray.isAlongX, ray.isAlongY);
    ray.shear = vec3(turned.x / turned.z, turned.y / turned.z, 1.0f / turned.z);
    return ray;
}

// The float 1 + q / 256, with the byte q taken from bits 15 to 22.
MANYLIGHT_FUNCTION float planeFactor(uint bits) { return uintBitsToFloat((bits & 0x007f8000u) | 0x3f800000u); }

// Where a ray meets one plane of each slot; `planes` is one of BvhNode's words of four.
MANYLIGHT_FUNCTION ivec4 planeDistances(uint planes, float stride, float start) {
    const float t0 = planeFactor(planes << 15) * stride + start;
    const float t1 = planeFactor(planes << 7) * stride + start;
    const float t2 = planeFactor(planes >> 1) * stride + start;
    const float t3 = planeFactor(planes >> 9) * stride + start;
    return ivec4(floatBitsToInt(t0), floatBitsToInt(t1), floatBitsToInt(t2), floatBitsToInt(t3));
}

// Slab tests of a node's children; `a`, `b` and `c` are its texels. No ray that meets a triangle misses its box: the
// boxes have room for the rounding of the planes, and kExitSlack is more than that of t. Distances are compared as
// integers: that has less latency than floats and needs no care for NaN. Negative floats do not sort as integers, but
// zero beats them all as an entry, and as an exit any of them will do.
MANYLIGHT_FUNCTION NodeVisit visitNode(TraversalRay ray, uvec4 a, uvec4 b, uvec4 c, float tMax) {
    const int kExitSlack = 16;  // units in the last place
    const vec3 frameOrigin = vec3(uintBitsToFloat(a.x), uintBitsToFloat(a.y), uintBitsToFloat(a.z));
    const vec3 frameSize = vec3(uintBitsToFloat((a.w & 255u) << 23), uintBitsToFloat(((a.w >> 8) & 255u) << 23),
                                uintBitsToFloat(((a.w >> 16) & 255u) << 23));
    const vec3 start = (frameOrigin - ray.origin) * ray.inverseDirection;
    const vec3 stride = frameSize * ray.inverseDirection;
    const ivec4 nearX = planeDistances(ray.isNegativeX ? b.y : b.x, stride.x, start.x);
    const ivec4 nearY = planeDistances(ray.isNegativeY ? b.w : b.z, stride.y, start.y);
    const ivec4 nearZ = planeDistances(ray.isNegativeZ ? c.y : c.x, stride.z, start.z);
    const ivec4 farX = planeDistances(ray.isNegativeX ? b.x : b.y, stride.x, start.x);
    const ivec4 farY = planeDistances(ray.isNegativeY ? b.z : b.w, stride.y, start.y);
    const ivec4 farZ = planeDistances(ray.isNegativeZ ? c.x : c.y, stride.z, start.z);

    NodeVisit visit;
    visit.entry = max(max(nearX, nearY), max(nearZ, ivec4(0)));
    const ivec4 exit = min(min(farX, farY), min(farZ, ivec4(floatBitsToInt(tMax))));
    const bvec4 isHit = lessThanEqual(visit.entry, exit + ivec4(kExitSlack));
    const uint hits = (isHit.x ? 1u : 0u) | (isHit.y ? 2u : 0u) | (isHit.z ? 4u : 0u) | (isHit.w ? 8u : 0u);
    visit.innerSlots = hits & (a.w >> 24);
    visit.leafSlots = (hits & (c.z >> 24)) | ((a.w >> 24) & 0x70u);
    visit.firstChild = c.z & 0x00ffffffu;
    visit.firstTriangle = c.w;
    return visit;
}

// Bits 0 to 3 of several words are a set of slots.
MANYLIGHT_FUNCTION bool hasSlots(uint word) { return (word & 15u) != 0u; }

MANYLIGHT_FUNCTION uint lowestSlotBit(uint word) { return word & (~word + 1u) & 15u; }

// 1, 2, 4, 8 -> 0, 1, 2, 3
MANYLIGHT_FUNCTION uint slotOfBit(uint bit) { return (bit >> 1) - (bit >> 3); }

// One leaf's triangles; the second is the first again if there is one only.
struct LeafTriangles {
    uint first;
    uint second;
};

// Of the leaf in the lowest of `leafSlots`; triangle 0 if there is none.
MANYLIGHT_FUNCTION LeafTriangles lowestLeaf(uint leafSlots, uint firstTriangle) {
    const uint bit = lowestSlotBit(leafSlots);
    const uint slot = slotOfBit(bit);
    const uint singlesStart = leafSlots >> 4;
    LeafTriangles triangles;
    triangles.first = bit != 0u ? firstTriangle + slot + min(slot, singlesStart) : 0u;
    triangles.second = bit != 0u && slot < singlesStart ? triangles.first + 1u : triangles.first;
    return triangles;
}

// A queue of up to three siblings, near ones first: bits 0-1, 2-3 and 4-5 are their slots, 6-7 their number, the rest
// is the node of the first inner child.
MANYLIGHT_FUNCTION uint queueLength(uint queue) { return (queue >> 6) & 3u; }

MANYLIGHT_FUNCTION uint queueFront(uint queue) { return (queue >> 8) + (queue & 3u); }

MANYLIGHT_FUNCTION uint withoutFront(uint queue) { return ((queue & ~63u) | ((queue & 63u) >> 2)) - 64u; }

// A visit's inner children in the order of their distance: the nearest, and the others as a queue. Without an inner
// child the nearest means nothing.
struct NearestFirst {
    uint nearest;
    uint others;
};

MANYLIGHT_FUNCTION NearestFirst nearestFirst(NodeVisit visit) {
    const int kNone = 0x7fffffff;
    // The slot takes the place of the last two bits of t.
    const int k0 = (visit.innerSlots & 1u) != 0u ? (visit.entry.x & ~3) : kNone;
    const int k1 = (visit.innerSlots & 2u) != 0u ? (visit.entry.y & ~3) | 1 : kNone;
    const int k2 = (visit.innerSlots & 4u) != 0u ? (visit.entry.z & ~3) | 2 : kNone;
    const int k3 = (visit.innerSlots & 8u) != 0u ? (visit.entry.w & ~3) | 3 : kNone;
    const int first = min(min(k0, k1), min(k2, k3));
    const int last = max(max(k0, k1), max(k2, k3));
    const int smallerLoser = max(min(k0, k1), min(k2, k3));
    const int largerWinner = min(max(k0, k1), max(k2, k3));
    const int second = min(smallerLoser, largerWinner);
    const int third = max(smallerLoser, largerWinner);
    const uint count = (second != kNone ? 1u : 0u) + (third != kNone ? 1u : 0u) + (last != kNone ? 1u : 0u);
    NearestFirst order;
    order.nearest = visit.firstChild + uint(first & 3);
    order.others =
        (visit.firstChild << 8) | (count << 6) | (uint(last & 3) << 4) | (uint(third & 3) << 2) | uint(second & 3);
    return order;
}

// A hit with t in (0, tMax] from either side. Two triangles that share an edge compute the same edge function but for
// its sign, and rounding is monotonic: its sign is never wrong, at worst it is zero, which counts as inside for both.
// So no ray passes between them, without the paper's second look in double (8 to 12 % of the speed on lavapipe).
MANYLIGHT_FUNCTION TriangleHit intersectTriangle(TraversalRay ray, vec3 v0, vec3 v1, vec3 v2, float tMax) {
    const vec3 a = permuted(v0 - ray.origin, ray.isAlongX, ray.isAlongY);
    const vec3 b = permuted(v1 - ray.origin, ray.isAlongX, ray.isAlongY);
    const vec3 c = permuted(v2 - ray.origin, ray.isAlongX, ray.isAlongY);
    MANYLIGHT_PRECISE const float ax = a.x - ray.shear.x * a.z;
    MANYLIGHT_PRECISE const float ay = a.y - ray.shear.y * a.z;
    MANYLIGHT_PRECISE const float bx = b.x - ray.shear.x * b.z;
    MANYLIGHT_PRECISE const float by = b.y - ray.shear.y * b.z;
    MANYLIGHT_PRECISE const float cx = c.x - ray.shear.x * c.z;
    MANYLIGHT_PRECISE const float cy = c.y - ray.shear.y * c.z;
    MANYLIGHT_PRECISE const float u = cx * by - cy * bx;
    MANYLIGHT_PRECISE const float v = ax * cy - ay * cx;
    MANYLIGHT_PRECISE const float w = bx * ay - by * ax;
    MANYLIGHT_PRECISE const float determinant = u + v + w;
    const float inverse = 1.0f / determinant;
    MANYLIGHT_PRECISE const float t = (u * a.z + v * b.z + w * c.z) * inverse * ray.shear.z;
    const bool isInside = (u >= 0.0f && v >= 0.0f && w >= 0.0f) || (u <= 0.0f && v <= 0.0f && w <= 0.0f);
    TriangleHit hit;
    hit.isHit = isInside && determinant != 0.0f && t > 0.0f && t <= tMax;
    hit.t = t;
    hit.barycentrics = vec2(v * inverse, w * inverse);
    return hit;
}

MANYLIGHT_SHARED_END
#endif
