#include "engine/passes/vpl_bounce.h"

#include "shaders/shared/bindings.h"

namespace manylight {

void addVplBounces(FrameGraph& graph, SceneHandles& scene, const gpu::Specialisation& surfaceOptions,
                   PathBuffers& paths, const shared::EmissionPush& push) {
    for (uint32_t depth = 0; depth < push.maxDepth; depth += shared::kBouncesPerDispatch) {
        PassBuilder pass = graph.addPass("vpl_bounce");
        readSurfaces(pass, scene, PipelineKind::Compute);
        readRays(pass, scene, PipelineKind::Compute);
        paths.rays = pass.write(paths.rays, Access::ComputeStorageReadWrite, shared::kBindingRays);
        paths.offsets = pass.write(paths.offsets, Access::ComputeStorageReadWrite, shared::kBindingPathOffsets);
        // The first stretch of bounces starts the slots anew; later ones add to them.
        const Access slots = depth == 0 ? Access::ComputeStorageWrite : Access::ComputeStorageReadWrite;
        paths.vertices = pass.write(paths.vertices, slots, shared::kBindingPathVertices);
        paths.gloss = pass.write(paths.gloss, slots, shared::kBindingPathGloss);
        scene.status = pass.write(scene.status, Access::ComputeStorageReadWrite, shared::kBindingStatus);
        pass.execute([surfaceOptions, push](PassContext& context) {
            context.dispatch({.shader = "vpl_bounce.comp",
                              .group = gpu::rowOf(context.tuning().pathThreads),
                              .specialisation = surfaceOptions},
                             push.pathCount, 1, push);
        });
    }
}

}  // namespace manylight
