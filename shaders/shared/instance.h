// A mesh in the scene, as rays and rasterisation see it.
#ifndef MANYLIGHT_SHARED_INSTANCE_H
#define MANYLIGHT_SHARED_INSTANCE_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// scenePoint = sceneFromMesh * meshPoint + center, matrices by their rows. Triangles are numbered through all instances;
// behind the last one is a record whose firstNumber is their count.
struct Instance {
    vec3 meshFromScene0;
    uint bvhRoot;
    vec3 meshFromScene1;
    uint numberOffset;    // number of a triangle = where it is stored + this, in 32 bits
    vec3 meshFromScene2;
    uint firstNumber;
    vec3 center;
    uint instanceOfLeaf;  // of record k: the instance in leaf k of the upper BVH
    vec3 sceneFromMesh0;
    uint instanceCount;   // in the first record
    vec3 sceneFromMesh1;
    uint unused1;
    vec3 sceneFromMesh2;
    uint unused2;
};
MANYLIGHT_CONSTANT(int, kTexelsPerInstance, 7);

// Of a point or, without the centre, a direction. Every stage that places a vertex gets the same bits.
MANYLIGHT_FUNCTION vec3 placedInScene(vec3 row0, vec3 row1, vec3 row2, vec3 center, vec3 p) {
    MANYLIGHT_PRECISE const vec3 placed = vec3(row0.x * p.x + row0.y * p.y + row0.z * p.z + center.x,
                                               row1.x * p.x + row1.y * p.y + row1.z * p.z + center.y,
                                               row2.x * p.x + row2.y * p.y + row2.z * p.z + center.z);
    return placed;
}

#ifdef __cplusplus
static_assert(sizeof(Instance) == 16 * kTexelsPerInstance);
#endif

MANYLIGHT_SHARED_END
#endif
