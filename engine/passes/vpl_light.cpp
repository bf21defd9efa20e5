#include "engine/passes/vpl_light.h"

#include "engine/passes/shading_work.h"
#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"

#include <algorithm>

namespace manylight {

ImageHandle addVplLight(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                        const VplBuffers& vpls, const VplLightOptions& options, std::optional<ImageHandle> radiance,
                        uint32_t width, uint32_t height) {
    const bool shadows = options.castShadows;
    const uint32_t limit = shadows ? shared::kMaxShadowedVplsPerDispatch : shared::kMaxVplsPerDispatch;
    const uint32_t pixelsPerThread = shadows ? 1u : options.pixelsPerInvocation;
    for (const shared::ShadePush& push : shadingStretches(0, options.vplCount, limit, false)) {
        const bool adds = radiance.has_value();
        if (!adds)
            radiance = graph.createImage(options.cutOff ? "cut off" : "radiance",
                                         {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
        PassBuilder pass = graph.addPass(options.cutOff ? "vpl_cut_off" : "vpl_light");
        readSurfaces(pass, scene, PipelineKind::Compute);
        readGBuffer(pass, gbuffer);
        readVpls(pass, vpls, PipelineKind::Compute);
        if (shadows) readRays(pass, scene, PipelineKind::Compute);
        if (shadows) scene.status = pass.write(scene.status, Access::ComputeStorageReadWrite, shared::kBindingStatus);
        radiance = pass.write(*radiance, adds ? Access::ComputeStorageReadWrite : Access::ComputeStorageWrite,
                              shared::kBindingRadiance);
        gpu::Specialisation constants = surfaceOptions(plan);
        constants.insert(constants.end(), {shadows, options.subgroupSize, adds, pixelsPerThread, options.cutOff});
        pass.execute([constants, push, shadows, width, height, pixelsPerThread](PassContext& context) {
            const gpu::Tuning& tuning = context.tuning();
            const gpu::Workgroup tile = gpu::tileOf(shadows ? tuning.rayThreads : tuning.gatherThreads);
            const ComputeKernel kernel{.shader = shadows ? "vpl_light_shadowed.comp" : "vpl_light.comp",
                                       .group = tile,
                                       .specialisation = constants,
                                       .fullSubgroups = true};
            const uint32_t most = shadows ? shared::kMaxRaysInDispatch : shared::kMaxPairsInDispatch;
            const uint32_t rows =
                rowsPerDispatch(width, push.vplCount, most / tuning.dispatchParts, tile.height * pixelsPerThread);
            shared::ShadePush band = push;
            for (band.firstRow = 0; band.firstRow < height; band.firstRow += rows) {
                const uint32_t count = std::min(rows, height - band.firstRow);
                context.dispatch(kernel, width, (count + pixelsPerThread - 1) / pixelsPerThread, band);
            }
        });
    }
    return *radiance;
}

}  // namespace manylight
