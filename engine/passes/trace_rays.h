// Answers a list of ray queries: for measuring and testing the traversal that all passes share.
#pragma once

#include "engine/accel/ray_sets.h"
#include "engine/passes/gpu_scene.h"

namespace manylight {

struct RayBuffers {
    BufferHandle queries;  // shared::RayQuery per ray, in texels of R32G32B32A32_SFLOAT
    BufferHandle answers;  // room for answerBytes() per ray
};

/// Bytes of the answer to one ray: a uint flag for any hit, a shared::RayHit for the closest.
uint32_t answerBytes(RayKind kind);

/// Needs the BVH, triangles, instances and status of `scene`, nothing else.
void addTraceRays(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, RayBuffers& rays, uint32_t rayCount,
                  RayKind kind);

}  // namespace manylight
