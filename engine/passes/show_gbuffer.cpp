#include "engine/passes/show_gbuffer.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"

namespace manylight {

ImageHandle addShowGBuffer(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                           uint32_t channel, float depthScale, uint32_t width, uint32_t height) {
    ImageHandle radiance = graph.createImage("radiance", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    PassBuilder pass = graph.addPass("show_gbuffer");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readGBuffer(pass, gbuffer);
    radiance = pass.write(radiance, Access::ComputeStorageWrite, shared::kBindingRadiance);
    const shared::ShowPush push{channel, depthScale};
    pass.execute([options = surfaceOptions(plan), push, width, height](PassContext& context) {
        context.dispatch(
            {.shader = "show_gbuffer.comp", .group = gpu::imageGroup(context.tuning()), .specialisation = options},
            width, height, push);
    });
    return radiance;
}

}  // namespace manylight
