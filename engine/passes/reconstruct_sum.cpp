#include "engine/passes/reconstruct_sum.h"

#include "shaders/shared/bindings.h"

namespace manylight {

ImageHandle addReconstructSum(FrameGraph& graph, const SceneHandles& scene, ImageHandle light, ImageHandle filtered,
                              uint32_t width, uint32_t height) {
    PassBuilder pass = graph.addPass("reconstruct_sum");
    readFrame(pass, scene, PipelineKind::Compute);
    pass.read(filtered, Access::ComputeStorageRead, shared::kBindingReconstructed);
    light = pass.write(light, Access::ComputeStorageReadWrite, shared::kBindingReconstruction);
    pass.execute([width, height](PassContext& context) {
        context.dispatch({.shader = "reconstruct_sum.comp", .group = gpu::imageGroup(context.tuning())}, width, height);
    });
    return light;
}

}  // namespace manylight
