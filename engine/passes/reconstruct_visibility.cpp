#include "engine/passes/reconstruct_visibility.h"

#include "shaders/shared/bindings.h"
#include "shaders/shared/reconstruct.h"

namespace manylight {

UnshadowedAndVisibility addReconstructVisibility(FrameGraph& graph, const SceneHandles& scene, ImageHandle guide,
                                                 ImageHandle gathered, float width, uint32_t period, uint32_t rays,
                                                 uint32_t imageWidth, uint32_t imageHeight) {
    UnshadowedAndVisibility factors{
        graph.createImage("unshadowed light", {VK_FORMAT_R32G32B32A32_SFLOAT, imageWidth, imageHeight}),
        graph.createImage("visibility of VPLs", {VK_FORMAT_R32G32B32A32_SFLOAT, imageWidth, imageHeight})};
    PassBuilder pass = graph.addPass("reconstruct_visibility");
    readFrame(pass, scene, PipelineKind::Compute);
    pass.read(guide, Access::ComputeStorageRead, shared::kBindingGuide);
    pass.read(gathered, Access::ComputeStorageRead, shared::kBindingReconstructed);
    factors.unshadowed = pass.write(factors.unshadowed, Access::ComputeStorageWrite, shared::kBindingUnshadowed);
    factors.visibility = pass.write(factors.visibility, Access::ComputeStorageWrite, shared::kBindingReconstruction);
    const shared::VisibilityPush push{
        .width = width, .period = static_cast<float>(period), .rays = static_cast<float>(rays)};
    pass.execute([push, imageWidth, imageHeight](PassContext& context) {
        context.dispatch({.shader = "reconstruct_visibility.comp", .group = gpu::imageGroup(context.tuning())},
                         imageWidth, imageHeight, push);
    });
    return factors;
}

ImageHandle addReconstructProduct(FrameGraph& graph, const SceneHandles& scene, const UnshadowedAndVisibility& factors,
                                  uint32_t width, uint32_t height) {
    ImageHandle light = graph.createImage("smoother light", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    PassBuilder pass = graph.addPass("reconstruct_product");
    readFrame(pass, scene, PipelineKind::Compute);
    pass.read(factors.unshadowed, Access::ComputeStorageRead, shared::kBindingUnshadowed);
    pass.read(factors.visibility, Access::ComputeStorageRead, shared::kBindingReconstructed);
    light = pass.write(light, Access::ComputeStorageWrite, shared::kBindingReconstruction);
    pass.execute([width, height](PassContext& context) {
        context.dispatch({.shader = "reconstruct_product.comp", .group = gpu::imageGroup(context.tuning())}, width,
                         height);
    });
    return light;
}

}  // namespace manylight
