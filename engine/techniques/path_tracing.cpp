#include "engine/techniques/path_tracing.h"

#include "engine/passes/path_trace.h"

namespace manylight {

TechniqueResult declarePathTracing(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs) {
    const RenderSettings& settings = inputs.settings;
    // A light path of D surfaces is scattered once more, where the camera sees it.
    const auto most = static_cast<uint32_t>(settings.bounceCount.value_or(0)) + 1;
    const bool local = settings.lighting == Lighting::Local;
    const bool global = settings.lighting == Lighting::Global;
    const ImageHandle radiance = addPathTrace(graph, scene, inputs.plan,
                                              {.minScatterings = global ? 2u : 0u,
                                               .maxScatterings = local ? 1u : most,
                                               .russianRoulette = settings.russianRoulette,
                                               .jitter = settings.jitter},
                                              settings.width, settings.height);
    return {.radiance = radiance};
}

}  // namespace manylight
