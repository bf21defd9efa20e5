// The BVH as rays read it: 32 bytes per node, both children's boxes in 8-bit steps of a frame of the node's own.
#ifndef MANYLIGHT_SHARED_BVH_H
#define MANYLIGHT_SHARED_BVH_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// Node 0 is the root; nodes lie depth first. Each child is an inner node or a leaf of 1 to kBvhMaxLeafSize triangles.
// Plane q of an axis is at origin + (1 + q / 256) * 2^(exponent - 127): a float whose mantissa starts with q.
struct BvhNode {
    vec3 origin;
    // Bits 0-7, 8-15, 16-23: exponents of x, y, z. Bits 24-27, 28-31: triangles of the left and right child, 0 = inner.
    uint exponentsAndCounts;
    // Per axis, from the low byte: left lower, right lower, left upper, right upper plane. An absent child has lower >
    // upper.
    uint planesX;
    uint planesY;
    uint planesZ;
    // Two inner children: node of the right one (the left one is the next node). A leaf among them: its first triangle;
    // an inner sibling is the next node. Two leaves: the left one's first triangle; the right one's follow.
    uint index;
};

MANYLIGHT_CONSTANT(uint, kBvhMaxLeafSize, 2u);  // a traversal tests two at once, without a loop
MANYLIGHT_CONSTANT(int, kBvhStackSize, 48);  // more than the depth of any BVH that buildBvh() returns
MANYLIGHT_CONSTANT(uint, kBvhMaxTriangles, 0x07ffffffu);

// What a traversal has to visit next, in 32 bits: an inner node's index, or kBvhLeaf | first triangle * 16 | count.
MANYLIGHT_CONSTANT(uint, kBvhLeaf, 0x80000000u);
MANYLIGHT_CONSTANT(uint, kBvhDone, 0x80000000u);  // a leaf of no triangles: the bottom of the stack

MANYLIGHT_CONSTANT(uint, kNoHit, 0xffffffffu);

MANYLIGHT_SHARED_END
#endif
