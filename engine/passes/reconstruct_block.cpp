#include "engine/passes/reconstruct_block.h"

#include "shaders/shared/bindings.h"
#include "shaders/shared/reconstruct.h"

namespace manylight {

ImageHandle addReconstructBlock(FrameGraph& graph, const SceneHandles& scene, ImageHandle guide, ImageHandle gathered,
                                float width, uint32_t period, uint32_t imageWidth, uint32_t imageHeight) {
    ImageHandle mean = graph.createImage("mean light", {VK_FORMAT_R32G32B32A32_SFLOAT, imageWidth, imageHeight});
    PassBuilder pass = graph.addPass("reconstruct_block");
    readFrame(pass, scene, PipelineKind::Compute);
    pass.read(guide, Access::ComputeStorageRead, shared::kBindingGuide);
    pass.read(gathered, Access::ComputeStorageRead, shared::kBindingReconstructed);
    mean = pass.write(mean, Access::ComputeStorageWrite, shared::kBindingReconstruction);
    const shared::BlockPush push{.width = width, .period = static_cast<float>(period)};
    pass.execute([push, imageWidth, imageHeight](PassContext& context) {
        context.dispatch({.shader = "reconstruct_block.comp", .group = gpu::imageGroup(context.tuning())}, imageWidth,
                         imageHeight, push);
    });
    return mean;
}

}  // namespace manylight
