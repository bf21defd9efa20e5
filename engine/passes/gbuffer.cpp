#include "engine/passes/gbuffer.h"

#include "engine/passes/surface_options.h"
#include "engine/passes/visibility.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/tonemap.h"

namespace manylight {
GBuffer addGBuffer(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, uint32_t triangleCount,
                   uint32_t width, uint32_t height) {
    const Visibility visibility = addVisibility(graph, scene, triangleCount, width, height);
    GBuffer gbuffer;
    gbuffer.depth = visibility.depth;
    gbuffer.position = graph.createImage("G-buffer position", {VK_FORMAT_R32G32B32A32_UINT, width, height});
    gbuffer.shading = graph.createImage("G-buffer shading", {VK_FORMAT_R32G32B32A32_UINT, width, height});

    PassBuilder lookUp = graph.addPass("gbuffer");
    readSurfaces(lookUp, scene, PipelineKind::Compute);
    lookUp.read(visibility.triangle, Access::ComputeStorageRead, shared::kBindingVisibility);
    gbuffer.position = lookUp.write(gbuffer.position, Access::ComputeStorageWrite, shared::kBindingGBufferPosition);
    gbuffer.shading = lookUp.write(gbuffer.shading, Access::ComputeStorageWrite, shared::kBindingGBufferShading);
    lookUp.execute([options = surfaceOptions(plan), width, height](PassContext& context) {
        context.dispatch({.shader = "gbuffer.comp",
                          .groupWidth = shared::kImageGroupWidth,
                          .groupHeight = shared::kImageGroupHeight,
                          .specialisation = options},
                         width, height);
    });
    return gbuffer;
}

}  // namespace manylight
