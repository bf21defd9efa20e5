#include "engine/passes/trace_rays.h"

#include "shaders/shared/bindings.h"
#include "shaders/shared/trace_rays.h"

#include <algorithm>
#include <cstddef>

namespace manylight {

// The shader reads a query as two texels: origin and tMax, direction.
static_assert(sizeof(shared::RayQuery) == 32 && offsetof(shared::RayQuery, tMax) == 12 &&
              offsetof(shared::RayQuery, direction) == 16);

uint32_t answerBytes(RayKind kind) { return kind == RayKind::AnyHit ? sizeof(uint32_t) : sizeof(shared::RayHit); }

void addTraceRays(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, RayBuffers& rays, uint32_t rayCount,
                  RayKind kind) {
    PassBuilder pass = graph.addPass("trace_rays");
    pass.read(scene.bvhNodes, Access::ComputeTexelRead, shared::kBindingBvhNodes)
        .read(scene.triangles, Access::ComputeTexelRead, shared::kBindingTriangles)
        .read(scene.instances, Access::ComputeTexelRead, shared::kBindingInstances)
        .read(rays.queries, Access::ComputeTexelRead, shared::kBindingRayQueries);
    readRays(pass, scene, PipelineKind::Compute);
    rays.answers = pass.write(rays.answers, Access::ComputeStorageWrite, shared::kBindingRayAnswers);
    scene.status = pass.write(scene.status, Access::ComputeStorageReadWrite, shared::kBindingStatus);
    // Constants 0 to 9: of those of surfaceOptions() only the last is of interest.
    const gpu::Specialisation constants{kind == RayKind::AnyHit ? 1u : 0u, 0, 0, 0, 0, 0, 0, 0, 0, plan.instanced};
    pass.execute([rayCount, constants](PassContext& context) {
        const ComputeKernel kernel{
            .shader = "trace_rays.comp", .group = gpu::rowOf(shared::kTraceRaysGroupSize), .specialisation = constants};
        for (uint32_t first = 0; first < rayCount; first += shared::kMaxRaysPerDispatch) {
            const uint32_t count = std::min(rayCount - first, shared::kMaxRaysPerDispatch);
            context.dispatch(kernel, count, 1, shared::TraceRaysPush{first, first + count});
        }
    });
}

}  // namespace manylight
