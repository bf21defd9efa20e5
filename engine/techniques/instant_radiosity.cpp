#include "engine/techniques/instant_radiosity.h"

#include "engine/passes/compensation.h"
#include "engine/passes/direct_light.h"
#include "engine/passes/show_gbuffer.h"
#include "engine/passes/vpl_light.h"
#include "engine/techniques/lights_of_frame.h"

#include <optional>

namespace manylight {
namespace {

/// Which G-buffer channel is asked for, if any.
std::optional<uint32_t> channelShown(Show show) {
    switch (show) {
        case Show::Normal:
            return shared::kShowNormal;
        case Show::Albedo:
            return shared::kShowAlbedo;
        case Show::Depth:
            return shared::kShowDepth;
        case Show::Position:
            return shared::kShowPosition;
        case Show::Material:
            return shared::kShowMaterial;
        default:
            return std::nullopt;
    }
}

}  // namespace

TechniqueResult declareInstantRadiosity(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs) {
    const RenderSettings& settings = inputs.settings;
    const uint32_t width = settings.width;
    const uint32_t height = settings.height;
    const GBuffer gbuffer = addGBuffer(graph, scene, inputs.plan, inputs.gpuScene.draws, width, height);
    if (const auto channel = channelShown(settings.show))
        return {addShowGBuffer(graph, scene, inputs.plan, gbuffer, *channel, 0.5f / inputs.gpuScene.sphere.radius,
                               width, height),
                gbuffer.depth, std::nullopt};

    const LightsOfFrame lights = addLightsOfFrame(graph, scene, inputs);
    std::optional<ImageHandle> radiance;
    if (settings.lighting != Lighting::Global)
        radiance =
            addDirectLight(graph, scene, inputs.plan, gbuffer, lights.lightCount, settings.castShadows, width, height);
    VplLightOptions gather{.vplCount = lights.vplCount,
                           .castShadows = settings.castShadows,
                           .subgroupSize = inputs.subgroupSize,
                           .pixelsPerInvocation = inputs.pixelsPerInvocation};
    if (lights.vplCount > 0 || !radiance)
        radiance = addVplLight(graph, scene, inputs.plan, gbuffer, lights.vpls, gather, radiance, width, height);
    if (lights.vplCount > 0 && settings.clamp == ClampMode::Compensate)
        radiance = addCompensation(graph, scene, inputs.plan, gbuffer, lights.vpls, *radiance, width, height);
    TechniqueResult result{*radiance, gbuffer.depth, lights.list(), std::nullopt};
    if (inputs.keepsCutOff) {
        gather.cutOff = true;
        result.cutOff =
            addVplLight(graph, scene, inputs.plan, gbuffer, lights.vpls, gather, std::nullopt, width, height);
    }
    return result;
}

}  // namespace manylight
