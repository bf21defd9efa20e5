#include "engine/passes/compensation.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/vpl_light.h"

namespace manylight {

ImageHandle addCompensation(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                            const VplBuffers& vpls, ImageHandle radiance, uint32_t width, uint32_t height) {
    PassBuilder pass = graph.addPass("compensation");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readGBuffer(pass, gbuffer);
    readVpls(pass, vpls, PipelineKind::Compute);
    pass.read(scene.emitters, Access::ComputeStorageRead, shared::kBindingEmitters);
    scene.status = pass.write(scene.status, Access::ComputeStorageReadWrite, shared::kBindingStatus);
    radiance = pass.write(radiance, Access::ComputeStorageReadWrite, shared::kBindingRadiance);
    pass.execute([options = surfaceOptions(plan), width, height](PassContext& context) {
        context.dispatch({.shader = "compensation.comp",
                          .groupWidth = shared::kVplTileWidth,
                          .groupHeight = shared::kVplTileHeight,
                          .specialisation = options},
                         width, height);
    });
    return radiance;
}

}  // namespace manylight
