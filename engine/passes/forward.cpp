#include "engine/passes/forward.h"

#include "engine/passes/background.h"
#include "engine/passes/shading_work.h"
#include "engine/passes/surface_options.h"
#include "shaders/shared/bindings.h"
#include "shaders/shared/lights.h"

namespace manylight {
namespace {

/// The stretch's VPLs in a uniform buffer of the size the shader declares.
BufferHandle addVplWindow(FrameGraph& graph, BufferHandle vpls, const shared::ShadePush& push) {
    constexpr VkDeviceSize kVplBytes = sizeof(shared::LightData);
    const VkDeviceSize padded = paddedVplCount(push.vplCount);
    BufferHandle window = graph.createBuffer("VPL window", {shared::kMaxForwardVplsPerDraw * kVplBytes});
    PassBuilder pass = graph.addPass("vpl_window");
    pass.read(vpls, Access::TransferRead);
    window = pass.write(window, Access::TransferWrite);
    pass.execute([vpls, window, push, padded](PassContext& context) {
        if (push.vplCount == 0)
            context.fill(window, 0);
        else
            context.copy(vpls, push.firstVpl * kVplBytes, padded * kVplBytes, window);
    });
    return window;
}

/// A map is shown by addBackground(), where alpha is still zero.
VkClearValue clearValue(const ForwardOptions& options, const ScenePlan& plan) {
    const glm::vec3 radiance = options.showEmission ? options.environmentRadiance : glm::vec3(0.0f);
    return {.color = {.float32 = {radiance.x, radiance.y, radiance.z, plan.environmentMapped ? 0.0f : 1.0f}}};
}

}  // namespace

ForwardResult addForward(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const VplBuffers& vpls,
                         const ForwardOptions& options, std::optional<Visibility> prepass,
                         std::span<const DrawRange> draws, uint32_t width, uint32_t height) {
    const uint32_t limit = options.castShadows ? shared::kMaxShadowedVplsPerDispatch : shared::kMaxForwardVplsPerDraw;
    const auto stretches = shadingStretches(options.lightCount, options.vplCount, limit, options.showEmission);
    gpu::Specialisation common = surfaceOptions(plan);
    common.insert(common.end(), {options.castShadows, 0u, 0u, 0u, 0u});

    ForwardResult result;
    result.radiance = graph.createImage("radiance", {VK_FORMAT_R32G32B32A32_SFLOAT, width, height});
    for (size_t i = 0; i < stretches.size(); ++i) {
        if (i == 1 && !prepass) prepass = addVisibility(graph, scene, plan, draws, width, height);
        shared::ShadePush push = stretches[i];
        const BufferHandle window = addVplWindow(graph, vpls.list, push);
        push.firstGloss = push.firstVpl;
        push.firstVpl = 0;

        PassBuilder pass = graph.addPass("forward");
        readSurfaces(pass, scene, PipelineKind::Graphics);
        readRays(pass, scene, PipelineKind::Graphics);
        readVpls(pass, vpls, PipelineKind::Graphics);
        readEmitters(pass, scene, PipelineKind::Graphics);
        pass.read(window, Access::GraphicsUniform, shared::kBindingVpls);
        scene.status = pass.write(scene.status, Access::GraphicsStorageReadWrite, shared::kBindingStatus);
        result.radiance = i == 0 ? pass.write(result.radiance, Access::ColorWrite, clearValue(options, plan))
                                 : pass.write(result.radiance, Access::ColorBlend);
        const bool seenOnly = prepass.has_value();
        if (seenOnly) {
            pass.read(prepass->depth, Access::DepthRead)
                .read(prepass->triangle, Access::GraphicsStorageRead, shared::kBindingVisibility);
            result.depth = prepass->depth;
        } else {
            result.depth = pass.write(graph.createImage("depth", {VK_FORMAT_D32_SFLOAT, width, height}),
                                      Access::DepthWrite, VkClearValue{.depthStencil = {0.0f, 0}});
        }
        gpu::Specialisation constants = common;
        constants.push_back(options.compensates && i == 0);
        constants = withEmitterOptions(constants, plan);
        const char* const shader = seenOnly           ? "forward_visible.frag"
                                   : plan.alphaTested ? "forward_alpha.frag"
                                                      : "forward.frag";
        pass.execute(
            [constants, push, shader, vertexShader = geometryShader(plan), seenOnly, draws](PassContext& context) {
                context.draw({.vertexShader = vertexShader,
                              .fragmentShader = shader,
                              .specialisation = constants,
                              .depthCompare = seenOnly ? VK_COMPARE_OP_EQUAL : VK_COMPARE_OP_GREATER},
                             draws, push);
            });
    }
    if (plan.environmentMapped && options.showEmission)
        result.radiance = addBackground(graph, scene, plan, result.radiance, width, height);
    return result;
}

}  // namespace manylight
