#include "engine/techniques/forward_radiosity.h"

#include "engine/passes/forward.h"
#include "engine/techniques/lights_of_frame.h"

namespace manylight {

TechniqueResult declareForwardRadiosity(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs) {
    const RenderSettings& settings = inputs.settings;
    const std::span<const DrawRange> draws = inputs.gpuScene.draws;
    const LightsOfFrame lights = addLightsOfFrame(graph, scene, inputs);
    std::optional<Visibility> prepass;
    if (settings.technique == Technique::ForwardPrepass)
        prepass = addVisibility(graph, scene, inputs.plan, draws, settings.width, settings.height);
    const ForwardResult forward =
        addForward(graph, scene, inputs.plan, lights.vpls,
                   {.lightCount = lights.lightCount,
                    .vplCount = lights.vplCount,
                    .castShadows = settings.castShadows,
                    .showEmission = settings.lighting != Lighting::Global,
                    .compensates = lights.vplCount > 0 && settings.clamp == ClampMode::Compensate,
                    .environmentRadiance = inputs.environmentRadiance},
                   prepass, draws, settings.width, settings.height);
    return {forward.radiance, forward.depth, lights.list()};
}

}  // namespace manylight
