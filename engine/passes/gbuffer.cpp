#include "engine/passes/gbuffer.h"

#include "engine/passes/surface_options.h"
#include "engine/passes/visibility.h"
#include "engine/passes/visibility_rays.h"
#include "shaders/shared/bindings.h"

namespace manylight {

GBuffer addGBuffer(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, std::span<const DrawRange> draws,
                   bool byRays, uint32_t width, uint32_t height) {
    GBuffer gbuffer;
    ImageHandle seen;
    if (byRays) {
        seen = addVisibilityByRays(graph, scene, plan, width, height);
    } else {
        const Visibility visibility = addVisibility(graph, scene, plan, draws, width, height);
        seen = visibility.triangle;
        gbuffer.depth = visibility.depth;
    }
    gbuffer.position = graph.createImage("G-buffer position", {VK_FORMAT_R32G32B32A32_UINT, width, height});
    gbuffer.shading = graph.createImage("G-buffer shading", {VK_FORMAT_R32G32B32A32_UINT, width, height});

    gbuffer.gloss = graph.createImage("G-buffer gloss",
                                      {VK_FORMAT_R32G32B32A32_UINT, plan.glossy ? width : 1, plan.glossy ? height : 1});

    PassBuilder lookUp = graph.addPass("gbuffer");
    readSurfaces(lookUp, scene, PipelineKind::Compute);
    lookUp.read(seen, Access::ComputeStorageRead, shared::kBindingVisibility);
    gbuffer.position = lookUp.write(gbuffer.position, Access::ComputeStorageWrite, shared::kBindingGBufferPosition);
    gbuffer.shading = lookUp.write(gbuffer.shading, Access::ComputeStorageWrite, shared::kBindingGBufferShading);
    gbuffer.gloss = lookUp.write(gbuffer.gloss, Access::ComputeStorageWrite, shared::kBindingGBufferGloss);
    lookUp.execute([options = surfaceOptions(plan), width, height](PassContext& context) {
        context.dispatch(
            {.shader = "gbuffer.comp", .group = gpu::imageGroup(context.tuning()), .specialisation = options}, width,
            height);
    });
    return gbuffer;
}

void readGBuffer(PassBuilder& pass, const GBuffer& gbuffer) {
    pass.read(gbuffer.position, Access::ComputeStorageRead, shared::kBindingGBufferPosition)
        .read(gbuffer.shading, Access::ComputeStorageRead, shared::kBindingGBufferShading)
        .read(gbuffer.gloss, Access::ComputeStorageRead, shared::kBindingGBufferGloss);
}

}  // namespace manylight
