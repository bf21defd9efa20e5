#include "engine/passes/visibility_rays.h"

#include "engine/passes/shading_work.h"
#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/visibility_rays.h"
#include "shaders/shared/vpl_light.h"

#include <algorithm>

namespace manylight {

ImageHandle addVisibilityByRays(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, uint32_t width,
                                uint32_t height) {
    PassBuilder pass = graph.addPass("visibility");
    readSurfaces(pass, scene, PipelineKind::Compute);
    readRays(pass, scene, PipelineKind::Compute);
    scene.status = pass.write(scene.status, Access::ComputeStorageReadWrite, shared::kBindingStatus);
    const ImageHandle triangle = pass.write(graph.createImage("visibility", {VK_FORMAT_R32_UINT, width, height}),
                                            Access::ComputeStorageWrite, shared::kBindingVisibility);
    pass.execute([options = surfaceOptions(plan), width, height](PassContext& context) {
        const gpu::Workgroup tile = gpu::tileOf(context.tuning().rayThreads);
        const uint32_t rows = rowsPerDispatch(width, 1, shared::kMaxRaysInDispatch, tile.height);
        for (uint32_t first = 0; first < height; first += rows) {
            const uint32_t end = std::min(first + rows, height);
            context.dispatch({.shader = "visibility_rays.comp", .group = tile, .specialisation = options}, width,
                             end - first, shared::VisibilityRaysPush{first, end});
        }
    });
    return triangle;
}

}  // namespace manylight
