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
uint32_t tileRows(const VplResampleOptions& options, const shared::ResamplePush& push, const gpu::Workgroup& tile,
                  uint32_t parts) {
    const uint32_t perPixel = divideUp(push.endVpl - push.firstVpl, subsetCount(options));
    const bool rayForEach = options.castShadows && options.shadowRays == 0;
    const uint64_t rays = !options.castShadows ? 0 : rayForEach ? perPixel : options.shadowRays;
    const uint64_t pixels = uint64_t{push.tilesAcross} * options.interleave * tile.width * tile.height;
    const uint64_t byRays = shared::kMaxRaysInDispatch / parts / std::max<uint64_t>(rays * pixels, 1);
    const uint64_t byPairs = shared::kMaxPairsInDispatch / parts / std::max<uint64_t>(2 * perPixel * pixels, 1);
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
        const shared::ResamplePush stretch{.interleave = n,
                                           .phase = options.phase,
                                           .firstVpl = firstVpl,
                                           .endVpl = std::min(firstVpl + limit, options.vplCount),
                                           .firstTileRow = 0,
                                           .tilesAcross = 0,  // as the tiles are
                                           .tilesDown = 0,
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
        pass.execute([constants, stretch, options, n, width, height](PassContext& context) {
            const gpu::Workgroup tile = gpu::tileOf(context.tuning().rayThreads);
            const ComputeKernel kernel{
                .shader = "vpl_resample.comp", .group = tile, .specialisation = constants, .fullSubgroups = true};
            shared::ResamplePush band = stretch;
            band.tilesAcross = divideUp(divideUp(width, n), tile.width);
            band.tilesDown = divideUp(divideUp(height, n), tile.height);
            const uint32_t rows = tileRows(options, band, tile, context.tuning().dispatchParts);
            for (band.firstTileRow = 0; band.firstTileRow < n * band.tilesDown; band.firstTileRow += rows) {
                const uint32_t count = std::min(rows, n * band.tilesDown - band.firstTileRow);
                context.dispatch(kernel, n * band.tilesAcross * tile.width, count * tile.height, band);
            }
        });
        firstVpl = stretch.endVpl;
    } while (firstVpl < options.vplCount);
    return *radiance;
}

}  // namespace manylight
