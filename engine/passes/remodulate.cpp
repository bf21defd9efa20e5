#include "engine/passes/remodulate.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"

namespace manylight {

ImageHandle addRemodulate(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                          ImageHandle light, std::optional<ImageHandle> radiance, uint32_t width, uint32_t height) {
    const bool adds = radiance.has_value();
    if (!adds) radiance = graph.createImage("radiance", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    PassBuilder pass = graph.addPass("remodulate");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readGBuffer(pass, gbuffer);
    pass.read(light, Access::ComputeStorageRead, shared::kBindingReconstructed);
    radiance = pass.write(*radiance, adds ? Access::ComputeStorageReadWrite : Access::ComputeStorageWrite,
                          shared::kBindingRadiance);
    gpu::Specialisation options = surfaceOptions(plan);
    options.resize(40, gpu::kAsInShader);
    options.push_back(adds);
    pass.execute([options, width, height](PassContext& context) {
        context.dispatch(
            {.shader = "remodulate.comp", .group = gpu::imageGroup(context.tuning()), .specialisation = options}, width,
            height);
    });
    return *radiance;
}

}  // namespace manylight
