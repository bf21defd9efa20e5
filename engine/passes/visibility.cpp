#include "engine/passes/visibility.h"

namespace manylight {

Visibility addVisibility(FrameGraph& graph, const SceneHandles& scene, uint32_t triangleCount, uint32_t width,
                         uint32_t height) {
    constexpr VkClearValue kFarAway{.depthStencil = {0.0f, 0}};
    constexpr VkClearValue kNothing{.color = {.uint32 = {0, 0, 0, 0}}};
    Visibility visibility;
    visibility.triangle = graph.createImage("visibility", {VK_FORMAT_R32_UINT, width, height});
    visibility.depth = graph.createImage("depth", {VK_FORMAT_D32_SFLOAT, width, height});
    PassBuilder pass = graph.addPass("visibility");
    readFrame(pass, scene, PipelineKind::Graphics);
    pass.read(scene.triangles, Access::VertexBuffer);
    visibility.triangle = pass.write(visibility.triangle, Access::ColorWrite, kNothing);
    visibility.depth = pass.write(visibility.depth, Access::DepthWrite, kFarAway);
    pass.execute([triangleCount](PassContext& context) {
        context.draw({.vertexShader = "geometry.vert",
                      .fragmentShader = "visibility.frag",
                      .depthCompare = VK_COMPARE_OP_GREATER},
                     triangleCount * 3);
    });
    return visibility;
}

}  // namespace manylight
