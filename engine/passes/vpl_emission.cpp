#include "engine/passes/vpl_emission.h"

#include "engine/passes/surface_options.h"
#include "engine/passes/vpl_compact.h"
#include "engine/passes/vpl_bounce.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/lights.h"
#include "shaders/shared/vpl_emission.h"
#include "shaders/shared/vpl_light.h"

#include <algorithm>

namespace manylight {
namespace {

/// Share of `total` that belongs to paths before `path`: shares of consecutive batches are disjoint and complete.
uint32_t shareBefore(uint32_t total, uint32_t path, uint32_t pathCount) {
    return static_cast<uint32_t>(uint64_t{total} * path / pathCount);
}

void emitPaths(FrameGraph& graph, const SceneHandles& scene, PathBuffers& paths, const shared::EmissionPush& push) {
    PassBuilder pass = graph.addPass("vpl_emission");
    readFrame(pass, scene, PipelineKind::Compute);
    pass.read(scene.emitters, Access::ComputeStorageRead, shared::kBindingEmitters);
    paths.rays = pass.write(paths.rays, Access::ComputeStorageWrite, shared::kBindingRays);
    paths.offsets = pass.write(paths.offsets, Access::ComputeStorageWrite, shared::kBindingPathOffsets);
    pass.execute([push](PassContext& context) {
        context.dispatch({.shader = "vpl_emission.comp", .groupWidth = shared::kEmissionGroupSize}, push.pathCount, 1,
                         push);
    });
}

}  // namespace

uint32_t paddedVplCount(uint32_t vplCount) {
    return (vplCount + shared::kVplPadding - 1) / shared::kVplPadding * shared::kVplPadding;
}

BufferHandle addVplEmission(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan,
                            const VplEmissionOptions& options) {
    const uint32_t batch = std::min(options.pathCount, shared::kPathsPerBatch);
    PathBuffers paths;
    paths.rays = graph.createBuffer("rays", {batch * sizeof(shared::Ray)});
    paths.offsets = graph.createBuffer("path offsets", {(size_t{batch} + 1) * sizeof(uint32_t)});
    paths.vertices = graph.createBuffer(
        "path vertices", {size_t{batch} * options.bounceCount * sizeof(shared::LightData)});
    BufferHandle vpls =
        graph.createBuffer("VPLs", {size_t{paddedVplCount(options.vplCount)} * sizeof(shared::LightData),
                                    VK_FORMAT_R32G32B32A32_SFLOAT});

    for (uint32_t first = 0; first < options.pathCount; first += batch) {
        const uint32_t count = std::min(batch, options.pathCount - first);
        const uint32_t firstVpl = shareBefore(options.vplCount, first, options.pathCount);
        const uint32_t endVpl = shareBefore(options.vplCount, first + count, options.pathCount);
        const bool isLast = first + count == options.pathCount;
        const shared::EmissionPush push{
            .firstPath = first,
            .pathCount = count,
            .maxDepth = options.bounceCount,
            .firstVpl = firstVpl,
            .vplCount = endVpl - firstVpl,
            .paddedVplCount = (isLast ? paddedVplCount(options.vplCount) : endVpl) - firstVpl,
            .russianRoulette = options.russianRoulette ? 1u : 0u,
        };
        emitPaths(graph, scene, paths, push);
        addVplBounces(graph, scene, surfaceOptions(plan), paths, push);
        vpls = addVplCompact(graph, scene, paths, vpls, push);
    }
    return vpls;
}

}  // namespace manylight
