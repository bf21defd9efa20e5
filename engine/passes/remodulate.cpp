#include "engine/passes/remodulate.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/reconstruct.h"

namespace manylight {

ImageHandle addRemodulate(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                          ImageHandle light, const std::optional<LightToBorrow>& borrowed, bool showEmission,
                          bool isLast, uint32_t width, uint32_t height) {
    PassBuilder pass = graph.addPass("remodulate");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readEmitters(pass, scene, PipelineKind::Compute);
    readGBuffer(pass, gbuffer);
    pass.read(light, Access::ComputeStorageRead, shared::kBindingReconstructed);
    ImageHandle radiance;
    if (borrowed) {
        pass.read(borrowed->guide, Access::ComputeStorageRead, shared::kBindingGuide);
        radiance = pass.write(borrowed->radiance, Access::ComputeStorageReadWrite, shared::kBindingRadiance);
    } else {
        radiance = pass.write(graph.createImage("radiance", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height}),
                              Access::ComputeStorageWrite, shared::kBindingRadiance);
    }
    gpu::Specialisation options = withEmitterOptions(surfaceOptions(plan), plan);
    options.resize(40, gpu::kAsInShader);
    options.insert(options.end(), {showEmission, borrowed.has_value()});
    const shared::RemodulatePush push{.toLight = borrowed ? borrowed->offset : glm::vec2(0.0f), .isLast = isLast};
    pass.execute([options, push, width, height](PassContext& context) {
        context.dispatch(
            {.shader = "remodulate.comp", .group = gpu::imageGroup(context.tuning()), .specialisation = options}, width,
            height, push);
    });
    return radiance;
}

}  // namespace manylight
