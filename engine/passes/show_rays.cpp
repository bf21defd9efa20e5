#include "engine/passes/show_rays.h"

#include "engine/passes/shading_work.h"
#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/show.h"

#include <algorithm>

namespace manylight {

ImageHandle addShowRays(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                        const VplBuffers& vpls, const ShowRaysOptions& options, uint32_t width, uint32_t height) {
    ImageHandle radiance = graph.createImage("radiance", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    for (const shared::ShadePush& stretch : shadingStretches(0, options.vplCount, shared::kMaxVplsPerDispatch, false)) {
        PassBuilder pass = graph.addPass("show_rays");
        readSurfaces(pass, scene, PipelineKind::Compute);
        readGBuffer(pass, gbuffer);
        readVpls(pass, vpls, PipelineKind::Compute);
        const bool isFirst = stretch.firstVpl == 0;
        radiance = pass.write(radiance, isFirst ? Access::ComputeStorageWrite : Access::ComputeStorageReadWrite,
                              shared::kBindingRadiance);
        gpu::Specialisation constants = surfaceOptions(plan);
        constants.insert(constants.end(), {false, options.subgroupSize});
        const shared::ShowRaysPush push{.firstVpl = stretch.firstVpl,
                                        .endVpl = stretch.firstVpl + stretch.vplCount,
                                        .vplCount = options.vplCount,
                                        .shadowRays = options.shadowRays,
                                        .interleave = options.interleave,
                                        .phase = options.phase,
                                        .firstRow = 0,
                                        .gatherStep = options.gatherStep,
                                        .gridStart = options.gridStart};
        pass.execute([constants, push, width, height](PassContext& context) {
            const gpu::Workgroup tile = gpu::tileOf(context.tuning().gatherThreads);
            const ComputeKernel kernel{
                .shader = "show_rays.comp", .group = tile, .specialisation = constants, .fullSubgroups = true};
            const uint32_t rows =
                rowsPerDispatch(width, push.endVpl - push.firstVpl, shared::kMaxPairsInDispatch, tile.height);
            shared::ShowRaysPush band = push;
            for (band.firstRow = 0; band.firstRow < height; band.firstRow += rows)
                context.dispatch(kernel, width, std::min(rows, height - band.firstRow), band);
        });
    }
    return radiance;
}

}  // namespace manylight
