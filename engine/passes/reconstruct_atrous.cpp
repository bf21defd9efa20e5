#include "engine/passes/reconstruct_atrous.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/reconstruct.h"
#include "shaders/shared/tonemap.h"

namespace manylight {

ImageHandle addReconstructAtrous(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan,
                                 const GBuffer& gbuffer, ImageHandle light, uint32_t spacing, float deviations,
                                 uint32_t width, uint32_t height) {
    ImageHandle smoother = graph.createImage("smoother light", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    PassBuilder pass = graph.addPass("reconstruct_atrous");
    readFrame(pass, scene, PipelineKind::Compute);
    readGBuffer(pass, gbuffer);
    pass.read(light, Access::ComputeStorageRead, shared::kBindingReconstructed);
    smoother = pass.write(smoother, Access::ComputeStorageWrite, shared::kBindingReconstruction);
    const shared::AtrousPush push{.spacing = static_cast<int>(spacing), .deviations = deviations};
    pass.execute([options = surfaceOptions(plan), push, width, height](PassContext& context) {
        context.dispatch({.shader = "reconstruct_atrous.comp",
                          .groupWidth = shared::kImageGroupWidth,
                          .groupHeight = shared::kImageGroupHeight,
                          .specialisation = options},
                         width, height, push);
    });
    return smoother;
}

}  // namespace manylight
