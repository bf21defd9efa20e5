#include "engine/passes/background.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"

namespace manylight {

ImageHandle addBackground(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, ImageHandle radiance,
                          uint32_t width, uint32_t height) {
    PassBuilder pass = graph.addPass("background");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readEmitters(pass, scene, PipelineKind::Compute);
    radiance = pass.write(radiance, Access::ComputeStorageReadWrite, shared::kBindingRadiance);
    pass.execute([options = withEmitterOptions(surfaceOptions(plan), plan), width, height](PassContext& context) {
        context.dispatch(
            {.shader = "background.comp", .group = gpu::imageGroup(context.tuning()), .specialisation = options}, width,
            height);
    });
    return radiance;
}

}  // namespace manylight
