#include "engine/passes/reconstruct_atrous.h"

#include "shaders/shared/bindings.h"
#include "shaders/shared/reconstruct.h"

namespace manylight {

ImageHandle addReconstructAtrous(FrameGraph& graph, const SceneHandles& scene, ImageHandle guide, ImageHandle light,
                                 uint32_t spacing, float deviations, uint32_t width, uint32_t height) {
    ImageHandle smoother = graph.createImage("smoother light", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    PassBuilder pass = graph.addPass("reconstruct_atrous");
    readFrame(pass, scene, PipelineKind::Compute);
    pass.read(guide, Access::ComputeStorageRead, shared::kBindingGuide);
    pass.read(light, Access::ComputeStorageRead, shared::kBindingReconstructed);
    smoother = pass.write(smoother, Access::ComputeStorageWrite, shared::kBindingReconstruction);
    const shared::AtrousPush push{.spacing = static_cast<int>(spacing), .deviations = deviations};
    pass.execute([push, width, height](PassContext& context) {
        context.dispatch({.shader = "reconstruct_atrous.comp", .group = gpu::imageGroup(context.tuning())}, width,
                         height, push);
    });
    return smoother;
}

}  // namespace manylight
