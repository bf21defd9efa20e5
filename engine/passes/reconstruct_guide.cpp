#include "engine/passes/reconstruct_guide.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"

namespace manylight {

ImageHandle addReconstructGuide(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan,
                                const GBuffer& gbuffer, uint32_t width, uint32_t height) {
    ImageHandle guide = graph.createImage("guide", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    PassBuilder pass = graph.addPass("reconstruct_guide");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readGBuffer(pass, gbuffer);
    guide = pass.write(guide, Access::ComputeStorageWrite, shared::kBindingGuide);
    pass.execute([options = surfaceOptions(plan), width, height](PassContext& context) {
        context.dispatch(
            {.shader = "reconstruct_guide.comp", .group = gpu::imageGroup(context.tuning()), .specialisation = options},
            width, height);
    });
    return guide;
}

}  // namespace manylight
