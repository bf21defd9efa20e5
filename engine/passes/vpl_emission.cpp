#include "engine/passes/vpl_emission.h"

#include "engine/core/check.h"
#include "engine/passes/surface_options.h"
#include "engine/passes/vpl_bounce.h"
#include "engine/passes/vpl_compact.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/lights.h"
#include "shaders/shared/vpl_emission.h"
#include "shaders/shared/vpl_light.h"

#include <algorithm>

namespace manylight {
namespace {

/// What of `total` belongs to the batches before `batch`: shares of consecutive batches are disjoint and complete.
uint32_t shareBefore(uint32_t total, uint32_t batch, uint32_t batchCount) {
    return static_cast<uint32_t>(uint64_t{total} * batch / batchCount);
}

void emitPaths(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, PathBuffers& paths,
               const shared::EmissionPush& push) {
    PassBuilder pass = graph.addPass("vpl_emission");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readEmitters(pass, scene, PipelineKind::Compute);
    paths.rays = pass.write(paths.rays, Access::ComputeStorageWrite, shared::kBindingRays);
    paths.offsets = pass.write(paths.offsets, Access::ComputeStorageWrite, shared::kBindingPathOffsets);
    pass.execute([options = withEmitterOptions(surfaceOptions(plan), plan), push](PassContext& context) {
        context.dispatch({.shader = "vpl_emission.comp",
                          .group = gpu::rowOf(context.tuning().pathThreads),
                          .specialisation = options},
                         push.pathCount, 1, push);
    });
}

}  // namespace

uint32_t pathsPerBatch(uint32_t bounceCount) {
    return std::clamp(shared::kVerticesPerBatch / std::max(bounceCount, 1u), 1u, shared::kPathsPerBatch);
}

VplBuffers addVplEmission(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan,
                          const VplEmissionOptions& options) {
    const uint32_t batchCount = (options.pathCount - 1) / pathsPerBatch(options.bounceCount) + 1;
    // A batch without an entry in the list would lose its light.
    MANYLIGHT_CHECK(batchCount <= options.vplCount, "vpl_emission");
    const uint32_t batch = (options.pathCount - 1) / batchCount + 1;
    PathBuffers paths;
    paths.rays = graph.createBuffer("rays", {batch * sizeof(shared::Ray)});
    paths.offsets = graph.createBuffer("path offsets", {(size_t{batch} + 1) * sizeof(uint32_t)});
    const size_t slots = size_t{batch} * options.bounceCount;
    paths.vertices = graph.createBuffer("path vertices", {slots * sizeof(shared::LightData)});
    paths.gloss = graph.createBuffer("path gloss", {(plan.glossy ? slots : 1) * sizeof(shared::VplGloss)});
    VplBuffers vpls = createVplBuffers(graph, plan, options.vplCount);

    for (uint32_t b = 0; b < batchCount; ++b) {
        const uint32_t first = shareBefore(options.pathCount, b, batchCount);
        const uint32_t count = shareBefore(options.pathCount, b + 1, batchCount) - first;
        const uint32_t firstVpl = shareBefore(options.vplCount, b, batchCount);
        const uint32_t endVpl = shareBefore(options.vplCount, b + 1, batchCount);
        const bool isLast = b + 1 == batchCount;
        const shared::EmissionPush push{
            .firstPath = first,
            .pathCount = count,
            .maxDepth = options.bounceCount,
            .firstVpl = firstVpl,
            .vplCount = endVpl - firstVpl,
            .paddedVplCount = (isLast ? paddedVplCount(options.vplCount) : endVpl) - firstVpl,
            .russianRoulette = options.russianRoulette ? 1u : 0u,
        };
        emitPaths(graph, scene, plan, paths, push);
        addVplBounces(graph, scene, surfaceOptions(plan), paths, push);
        vpls = addVplCompact(graph, scene, surfaceOptions(plan), paths, vpls, push);
    }
    return vpls;
}

}  // namespace manylight
