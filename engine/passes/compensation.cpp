#include "engine/passes/compensation.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/vpl_light.h"

namespace manylight {

ImageHandle addCompensation(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                            const VplBuffers& vpls, ImageHandle image, bool forReconstruction, uint32_t width,
                            uint32_t height) {
    PassBuilder pass = graph.addPass("compensation");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readRays(pass, scene, PipelineKind::Compute);
    readGBuffer(pass, gbuffer);
    readVpls(pass, vpls, PipelineKind::Compute);
    readEmitters(pass, scene, PipelineKind::Compute);
    scene.status = pass.write(scene.status, Access::ComputeStorageReadWrite, shared::kBindingStatus);
    image = pass.write(image, Access::ComputeStorageReadWrite, shared::kBindingRadiance);
    gpu::Specialisation constants = surfaceOptions(plan);
    constants.push_back(VK_TRUE);  // shadows: light that is given back is traced
    gpu::Specialisation options = withEmitterOptions(constants, plan);
    if (forReconstruction) {
        options.resize(40, gpu::kAsInShader);
        options.push_back(VK_TRUE);
    }
    pass.execute([options, width, height](PassContext& context) {
        context.dispatch({.shader = "compensation.comp",
                          .group = gpu::tileOf(context.tuning().rayThreads),
                          .specialisation = options},
                         width, height);
    });
    return image;
}

}  // namespace manylight
