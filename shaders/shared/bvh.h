// The BVH as rays read it: four children a node, 64 bytes, which is one cache line, their boxes in 8-bit steps of a frame of the node's own.
#ifndef MANYLIGHT_SHARED_BVH_H
#define MANYLIGHT_SHARED_BVH_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// Node 0 is the root. Slots 0 to 3 hold first the inner children, then leaves of two triangles, then leaves of one,
// then nothing. The largest inner box comes first, as an occluder is likeliest there, except near the root of a tree so
// deep that kBvhShortStackSize would not do. Plane q of an axis is at origin + (1 + q / 256) * 2^(exponent - 127): a
// float whose mantissa starts with q.
struct BvhNode {
    vec3 origin;
    // Bits 0-7, 8-15, 16-23: exponents of x, y, z. Bits 24-27: which slots hold inner children. Bits 28-30: how many
    // slots come before the leaves of one triangle.
    uint exponentsAndSlots;
    uint lowerX;  // a byte per slot, from the low one
    uint upperX;
    uint lowerY;
    uint upperY;
    uint lowerZ;
    uint upperZ;
    // Bits 0-23: node of the first inner child, which the others follow. Bits 24-27: which slots hold leaves.
    uint firstChildAndLeaves;
    // Triangles of the leaf in slot s start at firstTriangle + s + min(s, slots before the leaves of one triangle), in
    // 32 bits: as if two triangles of each inner child came before.
    uint firstTriangle;
    uvec4 padding;
};

MANYLIGHT_CONSTANT(int, kBvhTexelsPerNode, 4);  // three are read
MANYLIGHT_CONSTANT(uint, kBvhWidth, 4u);
MANYLIGHT_CONSTANT(uint, kBvhMaxLeafSize, 2u);         // a traversal tests two at once, without a loop
MANYLIGHT_CONSTANT(int, kBvhStackSize, 32);            // more than the depth of any BVH that buildBvh() returns
MANYLIGHT_CONSTANT(uint, kBvhShortStackSize, 12u);     // enough for visits in the order of slots, see Bvh::putAside
// The most that closest-hit queries may have in registers; so many are enough for a tree with one node more on its longest
// way down, as they put one group of siblings aside a node.
MANYLIGHT_CONSTANT(uint, kBvhRegisterStackSize, 16u);
MANYLIGHT_CONSTANT(uint, kBvhMaxTriangles, 3u << 23);  // as many give at most 2^24 nodes, as bits 0-23 can tell

MANYLIGHT_CONSTANT(uint, kNoHit, 0xffffffffu);

MANYLIGHT_SHARED_END
#endif
