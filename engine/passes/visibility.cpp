#include "engine/passes/visibility.h"

#include "engine/passes/surface_options.h"

namespace manylight {

const char* geometryShader(const ScenePlan& plan) {
    if (plan.instanced) return "geometry_instanced.vert";
    return plan.culled ? "geometry_culled.vert" : "geometry.vert";
}

Visibility addVisibility(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan,
                         std::span<const DrawRange> draws, uint32_t width, uint32_t height) {
    constexpr VkClearValue kFarAway{.depthStencil = {0.0f, 0}};
    constexpr VkClearValue kNothing{.color = {.uint32 = {0, 0, 0, 0}}};
    Visibility visibility;
    visibility.triangle = graph.createImage("visibility", {VK_FORMAT_R32_UINT, width, height});
    visibility.depth = graph.createImage("depth", {VK_FORMAT_D32_SFLOAT, width, height});
    PassBuilder pass = graph.addPass("visibility");
    if (plan.alphaTested || plan.culled || plan.instanced)
        readSurfaces(pass, scene, PipelineKind::Graphics);
    else {
        readFrame(pass, scene, PipelineKind::Graphics);
        pass.read(scene.triangles, Access::VertexBuffer);
    }
    visibility.triangle = pass.write(visibility.triangle, Access::ColorWrite, kNothing);
    visibility.depth = pass.write(visibility.depth, Access::DepthWrite, kFarAway);
    pass.execute([draws, vertexShader = geometryShader(plan), isTested = plan.alphaTested,
                  options = surfaceOptions(plan)](PassContext& context) {
        context.draw({.vertexShader = vertexShader,
                      .fragmentShader = isTested ? "visibility_alpha.frag" : "visibility.frag",
                      .specialisation = options,
                      .depthCompare = VK_COMPARE_OP_GREATER},
                     draws);
    });
    return visibility;
}

}  // namespace manylight
