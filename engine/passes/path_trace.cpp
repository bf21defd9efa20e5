#include "engine/passes/path_trace.h"

#include "engine/passes/shading_work.h"
#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/path_trace.h"
#include "shaders/shared/vpl_light.h"

#include <algorithm>

namespace manylight {
namespace {

/// Rows that are traced together.
struct Band {
    uint32_t firstRow = 0;
    uint32_t endRow = 0;
};

}  // namespace

ImageHandle addPathTrace(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const PathTraceOptions& options,
                         uint32_t width, uint32_t height) {
    ImageHandle radiance = graph.createImage("radiance", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    const uint32_t stretches = options.maxScatterings / shared::kSurfacesPerDispatch + 1;
    // Two rays a surface; most paths are short, and a picture takes a few bands at most.
    constexpr uint32_t kRaysOfPath = 32;
    constexpr uint32_t kRowStep = 8;  // of bands: whole rows of tiles, for the most part
    const uint32_t most = stretches == 1 ? shared::kMaxRaysInDispatch : kRaysOfPath * shared::kPathStatesPerBand;
    const uint32_t rows = rowsPerDispatch(width, kRaysOfPath, most, kRowStep);
    // Paths that fit one dispatch need no states.
    const size_t stateCount = stretches == 1 ? 1 : size_t{width} * std::min(rows, height);
    BufferHandle states = graph.createBuffer("path states", {stateCount * sizeof(shared::PathState)});

    for (Band band{0, std::min(rows, height)}; band.firstRow < height;
         band = {band.endRow, std::min(band.endRow + rows, height)}) {
        for (uint32_t stretch = 0; stretch < stretches; ++stretch) {
            const bool resumes = stretch > 0;
            const bool suspends = stretch + 1 < stretches;
            PassBuilder pass = graph.addPass("path_trace");
            readSurfaces(pass, scene, PipelineKind::Compute);
            readRays(pass, scene, PipelineKind::Compute);
            readEmitters(pass, scene, PipelineKind::Compute);
            scene.status = pass.write(scene.status, Access::ComputeStorageReadWrite, shared::kBindingStatus);
            states = pass.write(states, resumes ? Access::ComputeStorageReadWrite : Access::ComputeStorageWrite,
                                shared::kBindingPathStates);
            const bool isFirst = band.firstRow == 0 && stretch == 0;
            radiance = pass.write(radiance, isFirst ? Access::ComputeStorageWrite : Access::ComputeStorageReadWrite,
                                  shared::kBindingRadiance);
            const shared::PathTracePush push{.firstRow = band.firstRow,
                                             .endRow = band.endRow,
                                             .minScatterings = options.minScatterings,
                                             .maxScatterings = options.maxScatterings,
                                             .russianRoulette = options.russianRoulette ? 1u : 0u,
                                             .jitter = options.jitter ? 1u : 0u};
            gpu::Specialisation constants = surfaceOptions(plan);
            constants.insert(constants.end(), {resumes, suspends});
            constants = withEmitterOptions(constants, plan);
            pass.execute([constants, push, width](PassContext& context) {
                context.dispatch({.shader = "path_trace.comp",
                                  .group = gpu::tileOf(context.tuning().rayThreads),
                                  .specialisation = constants},
                                 width, push.endRow - push.firstRow, push);
            });
        }
    }
    return radiance;
}

}  // namespace manylight
