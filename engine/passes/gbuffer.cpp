#include "engine/passes/gbuffer.h"

#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/tonemap.h"

namespace manylight {
namespace {

constexpr VkClearValue kFarAway{.depthStencil = {0.0f, 0}};
constexpr VkClearValue kNothing{.color = {.uint32 = {0, 0, 0, 0}}};

}  // namespace

GBuffer addGBuffer(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, uint32_t triangleCount,
                   uint32_t width, uint32_t height) {
    GBuffer gbuffer;
    gbuffer.depth = graph.createImage("depth", {VK_FORMAT_D32_SFLOAT, width, height});
    gbuffer.position = graph.createImage("G-buffer position", {VK_FORMAT_R32G32B32A32_UINT, width, height});
    gbuffer.shading = graph.createImage("G-buffer shading", {VK_FORMAT_R32G32B32A32_UINT, width, height});
    ImageHandle visibility = graph.createImage("visibility", {VK_FORMAT_R32_UINT, width, height});

    PassBuilder raster = graph.addPass("visibility");
    readFrame(raster, scene, PipelineKind::Graphics);
    raster.read(scene.triangles, Access::VertexBuffer);
    visibility = raster.write(visibility, Access::ColorWrite, kNothing);
    gbuffer.depth = raster.write(gbuffer.depth, Access::DepthWrite, kFarAway);
    raster.execute([triangleCount](PassContext& context) {
        context.draw({.vertexShader = "geometry.vert",
                      .fragmentShader = "visibility.frag",
                      .depthCompare = VK_COMPARE_OP_GREATER},
                     triangleCount * 3);
    });

    PassBuilder lookUp = graph.addPass("gbuffer");
    readSurfaces(lookUp, scene, PipelineKind::Compute);
    lookUp.read(visibility, Access::ComputeStorageRead, shared::kBindingVisibility);
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

ImageHandle addDepthPrepass(FrameGraph& graph, const SceneHandles& scene, uint32_t triangleCount, uint32_t width,
                            uint32_t height) {
    PassBuilder pass = graph.addPass("depth_prepass");
    readFrame(pass, scene, PipelineKind::Graphics);
    pass.read(scene.triangles, Access::VertexBuffer);
    const ImageHandle depth =
        pass.write(graph.createImage("depth", {VK_FORMAT_D32_SFLOAT, width, height}), Access::DepthWrite, kFarAway);
    pass.execute([triangleCount](PassContext& context) {
        context.draw({.vertexShader = "geometry.vert", .depthCompare = VK_COMPARE_OP_GREATER}, triangleCount * 3);
    });
    return depth;
}

}  // namespace manylight
