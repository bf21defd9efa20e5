#include "engine/passes/remodulate.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/reconstruct.h"

namespace manylight {

ImageHandle addRemodulate(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                          std::optional<ImageHandle> own, const std::optional<LentLight>& lent,
                          std::optional<ImageHandle> radiance, float scale, uint32_t width, uint32_t height) {
    const bool adds = radiance.has_value();
    if (!adds) radiance = graph.createImage("radiance", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    PassBuilder pass = graph.addPass("remodulate");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readGBuffer(pass, gbuffer);
    if (own) pass.read(*own, Access::ComputeStorageRead, shared::kBindingReconstructed);
    if (lent) {
        pass.read(lent->guide, Access::ComputeStorageRead, shared::kBindingGuide);
        pass.read(lent->light, Access::ComputeStorageRead, shared::kBindingLentLight);
    }
    radiance = pass.write(*radiance, adds ? Access::ComputeStorageReadWrite : Access::ComputeStorageWrite,
                          shared::kBindingRadiance);
    gpu::Specialisation options = surfaceOptions(plan);
    options.resize(40, gpu::kAsInShader);
    options.insert(options.end(), {adds, own.has_value(), lent.has_value()});
    const shared::RemodulatePush push{.toLender = lent ? lent->offset : glm::vec2(0.0f), .scale = scale};
    pass.execute([options, push, width, height](PassContext& context) {
        context.dispatch(
            {.shader = "remodulate.comp", .group = gpu::imageGroup(context.tuning()), .specialisation = options}, width,
            height, push);
    });
    return *radiance;
}

}  // namespace manylight
