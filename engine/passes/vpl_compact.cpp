#include "engine/passes/vpl_compact.h"

#include "shaders/shared/bindings.h"

namespace manylight {

VplBuffers addVplCompact(FrameGraph& graph, SceneHandles& scene, const gpu::Specialisation& surfaceOptions,
                         PathBuffers& paths, VplBuffers vpls, const shared::EmissionPush& push) {
    PassBuilder scan = graph.addPass("vpl_scan");
    paths.offsets = scan.write(paths.offsets, Access::ComputeStorageReadWrite, shared::kBindingPathOffsets);
    scan.execute([push](PassContext& context) {
        context.dispatch({.shader = "vpl_scan.comp", .group = gpu::rowOf(shared::kScanGroupSize)},
                         shared::kScanGroupSize, 1, push);
    });

    PassBuilder compact = graph.addPass("vpl_compact");
    readFrame(compact, scene, PipelineKind::Compute);
    compact.read(paths.offsets, Access::ComputeStorageRead, shared::kBindingPathOffsets)
        .read(paths.vertices, Access::ComputeStorageRead, shared::kBindingPathVertices)
        .read(paths.gloss, Access::ComputeStorageRead, shared::kBindingPathGloss);
    scene.status = compact.write(scene.status, Access::ComputeStorageReadWrite, shared::kBindingStatus);
    const Access list = push.firstPath == 0 ? Access::ComputeStorageWrite : Access::ComputeStorageReadWrite;
    vpls.list = compact.write(vpls.list, list, shared::kBindingVpls);
    vpls.gloss = compact.write(vpls.gloss, list, shared::kBindingVplGloss);
    compact.execute([surfaceOptions, push](PassContext& context) {
        context.dispatch({.shader = "vpl_compact.comp",
                          .group = gpu::rowOf(context.tuning().pathThreads),
                          .specialisation = surfaceOptions},
                         push.paddedVplCount, 1, push);
    });
    return vpls;
}

}  // namespace manylight
