#include "engine/passes/temporal.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"

namespace manylight {

ImageHandle addReprojection(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                            ImageHandle radiance, const TemporalImages& before, ImageHandle history,
                            const shared::ReprojectionPush& push, uint32_t width, uint32_t height) {
    PassBuilder pass = graph.addPass("reproject");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readGBuffer(pass, gbuffer);
    pass.read(radiance, Access::ComputeStorageRead, shared::kBindingRadiance)
        .read(before.shown, Access::ComputeStorageRead, shared::kBindingShown)
        .read(before.guide, Access::ComputeStorageRead, shared::kBindingHistoryGuide);
    history = pass.write(history, Access::ComputeStorageWrite, shared::kBindingHistory);
    pass.execute([options = surfaceOptions(plan), push, width, height](PassContext& context) {
        context.dispatch(
            {.shader = "reproject.comp", .group = gpu::imageGroup(context.tuning()), .specialisation = options}, width,
            height, push);
    });
    return history;
}

TemporalImages addTemporal(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                           ImageHandle radiance, ImageHandle sum, ImageHandle history, bool hasHistory,
                           TemporalImages images, uint32_t frameCount, uint32_t width, uint32_t height) {
    const bool isFirst = frameCount == 1;
    PassBuilder pass = graph.addPass("temporal");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readGBuffer(pass, gbuffer);
    pass.read(radiance, Access::ComputeStorageRead, shared::kBindingRadiance)
        .read(sum, Access::ComputeStorageRead, shared::kBindingRadianceSum);
    pass.write(history, hasHistory ? Access::ComputeStorageReadWrite : Access::ComputeStorageWrite,
               shared::kBindingHistory);
    images.shown = pass.write(images.shown, Access::ComputeStorageWrite, shared::kBindingShown);
    images.guide = pass.write(images.guide, isFirst ? Access::ComputeStorageWrite : Access::ComputeStorageReadWrite,
                              shared::kBindingHistoryGuide);
    gpu::Specialisation options = surfaceOptions(plan);
    options.resize(40, gpu::kAsInShader);
    options.insert(options.end(), {isFirst, hasHistory});
    const shared::TemporalPush push{.frames = static_cast<float>(frameCount)};
    pass.execute([options, push, width, height](PassContext& context) {
        context.dispatch(
            {.shader = "temporal.comp", .group = gpu::imageGroup(context.tuning()), .specialisation = options}, width,
            height, push);
    });
    return images;
}

}  // namespace manylight
