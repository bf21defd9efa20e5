#include "engine/passes/vpl_resample.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/vpl_light.h"
#include "shaders/shared/vpl_resample.h"

#include <algorithm>

namespace manylight {
namespace {

uint32_t divideUp(uint32_t a, uint32_t b) { return (a + b - 1) / b; }

/// Every pixel that gathers meets one VPL in so many.
uint32_t subsetCount(const VplResampleOptions& options) {
    const uint32_t period = options.interleave / options.gatherStep;
    return period * period;
}

/// VPLs of one dispatch.
uint32_t vplsPerDispatch(const VplResampleOptions& options) {
    const bool rayForEach = options.castShadows && options.shadowRays == 0;
    const uint32_t perPixel = rayForEach ? shared::kMaxShadowedVplsPerDispatch : shared::kMaxResampledVpls;
    return perPixel * subsetCount(options);
}

/// Rows of tiles that keep a dispatch below the work that a watchdog allows.
uint32_t tileRows(const VplResampleOptions& options, const shared::ResamplePush& push) {
    const uint32_t perPixel = divideUp(push.endVpl - push.firstVpl, subsetCount(options));
    const bool rayForEach = options.castShadows && options.shadowRays == 0;
    const uint64_t rays = !options.castShadows ? 0 : rayForEach ? perPixel : options.shadowRays;
    const uint64_t pixels =
        uint64_t{push.tilesAcross} * options.interleave * shared::kVplTileWidth * shared::kVplTileHeight;
    const uint64_t byRays = shared::kMaxRaysInDispatch / std::max<uint64_t>(rays * pixels, 1);
    const uint64_t byPairs = shared::kMaxPairsInDispatch / std::max<uint64_t>(2 * perPixel * pixels, 1);
    return static_cast<uint32_t>(std::clamp<uint64_t>(std::min(byRays, byPairs), 1, 1u << 16));
}

}  // namespace

ImageHandle addVplResample(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                           const VplBuffers& vpls, const VplResampleOptions& options,
                           std::optional<ImageHandle> radiance, uint32_t width, uint32_t height) {
    const uint32_t n = options.interleave;
    const uint32_t limit = vplsPerDispatch(options);
    uint32_t firstVpl = 0;
    do {
        const shared::ResamplePush push{.interleave = n,
                                        .phase = options.phase,
                                        .firstVpl = firstVpl,
                                        .endVpl = std::min(firstVpl + limit, options.vplCount),
                                        .firstTileRow = 0,
                                        .tilesAcross = divideUp(divideUp(width, n), shared::kVplTileWidth),
                                        .tilesDown = divideUp(divideUp(height, n), shared::kVplTileHeight),
                                        .gridStart = options.gridStart};
        const bool adds = radiance.has_value();
        if (!adds)
            radiance = graph.createImage(options.forReconstruction ? "gathered light" : "radiance",
                                         {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
        PassBuilder pass = graph.addPass("vpl_light");
        readSurfaces(pass, scene, PipelineKind::Compute);
        readRays(pass, scene, PipelineKind::Compute);
        readGBuffer(pass, gbuffer);
        readVpls(pass, vpls, PipelineKind::Compute);
        scene.status = pass.write(scene.status, Access::ComputeStorageReadWrite, shared::kBindingStatus);
        radiance = pass.write(*radiance, adds ? Access::ComputeStorageReadWrite : Access::ComputeStorageWrite,
                              shared::kBindingRadiance);
        gpu::Specialisation constants = surfaceOptions(plan);
        constants.insert(constants.end(), {options.castShadows, options.subgroupSize, adds, options.shadowRays});
        if (options.forReconstruction) {
            constants.resize(40, gpu::kAsInShader);
            constants.insert(constants.end(), {VK_TRUE, options.gatherStep, options.visibilityApart});
        }
        pass.execute([constants, push, n, rows = tileRows(options, push)](PassContext& context) {
            const ComputeKernel kernel{.shader = "vpl_resample.comp",
                                       .groupWidth = shared::kVplTileWidth,
                                       .groupHeight = shared::kVplTileHeight,
                                       .specialisation = constants,
                                       .fullSubgroups = true};
            shared::ResamplePush band = push;
            for (band.firstTileRow = 0; band.firstTileRow < n * push.tilesDown; band.firstTileRow += rows) {
                const uint32_t count = std::min(rows, n * push.tilesDown - band.firstTileRow);
                context.dispatch(kernel, n * push.tilesAcross * shared::kVplTileWidth, count * shared::kVplTileHeight,
                                 band);
            }
        });
        firstVpl = push.endVpl;
    } while (firstVpl < options.vplCount);
    return *radiance;
}

}  // namespace manylight
