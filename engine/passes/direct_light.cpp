#include "engine/passes/direct_light.h"

#include "engine/passes/shading_work.h"
#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"

#include <algorithm>

namespace manylight {

DirectLight addDirectLight(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                           const DirectLightOptions& light, uint32_t width, uint32_t height) {
    DirectLight direct;
    direct.radiance = light.radiance ? *light.radiance
                                     : graph.createImage("radiance", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    if (light.areasApart)
        direct.areaLight = graph.createImage("light of areas", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    const uint32_t limit = light.castShadows ? shared::kMaxShadowedVplsPerDispatch : shared::kMaxVplsPerDispatch;
    for (const shared::ShadePush& push : shadingStretches(light.lightCount, 0, limit, true)) {
        const bool adds = push.firstLight > 0 || light.radiance;
        PassBuilder pass = graph.addPass("direct_light");
        readSurfaces(pass, scene, PipelineKind::Compute);
        readRays(pass, scene, PipelineKind::Compute);
        readGBuffer(pass, gbuffer);
        readEmitters(pass, scene, PipelineKind::Compute);
        scene.status = pass.write(scene.status, Access::ComputeStorageReadWrite, shared::kBindingStatus);
        const Access access = adds ? Access::ComputeStorageReadWrite : Access::ComputeStorageWrite;
        direct.radiance = pass.write(direct.radiance, access, shared::kBindingRadiance);
        const bool addsAreas = push.firstLight > 0;
        if (direct.areaLight)
            direct.areaLight =
                pass.write(*direct.areaLight, addsAreas ? Access::ComputeStorageReadWrite : Access::ComputeStorageWrite,
                           shared::kBindingReconstructed);
        gpu::Specialisation options = surfaceOptions(plan);
        options.insert(options.end(), {light.castShadows, 0u, adds});
        options = withEmitterOptions(options, plan);
        options.push_back(light.candidates);
        if (light.areasApart) {
            options.resize(40, gpu::kAsInShader);
            options.insert(options.end(), {VK_TRUE, addsAreas});
        }
        pass.execute([options, push, width, height](PassContext& context) {
            const gpu::Workgroup tile = gpu::tileOf(context.tuning().rayThreads);
            const ComputeKernel kernel{.shader = "direct_light.comp", .group = tile, .specialisation = options};
            const uint32_t rows = rowsPerDispatch(
                width, push.lightCount, shared::kMaxRaysInDispatch / context.tuning().dispatchParts, tile.height);
            shared::ShadePush band = push;
            for (band.firstRow = 0; band.firstRow < height; band.firstRow += rows)
                context.dispatch(kernel, width, std::min(rows, height - band.firstRow), band);
        });
    }
    return direct;
}

}  // namespace manylight
