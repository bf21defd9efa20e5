#include "engine/techniques/lights_of_frame.h"

#include "engine/passes/vpl_emission.h"
#include "engine/techniques/reconstruction.h"

namespace manylight {
namespace {

/// A list of dark VPLs, for shaders that want one bound.
VplBuffers addDarkVpls(FrameGraph& graph, const ScenePlan& plan) {
    VplBuffers vpls = createVplBuffers(graph, plan, 1);
    PassBuilder pass = graph.addPass("dark_vpls");
    vpls.list = pass.write(vpls.list, Access::TransferWrite);
    vpls.gloss = pass.write(vpls.gloss, Access::TransferWrite);
    pass.execute([vpls](PassContext& context) {
        context.fill(vpls.list, 0);
        context.fill(vpls.gloss, 0);
    });
    return vpls;
}

}  // namespace

LightsOfFrame addLightsOfFrame(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs) {
    const RenderSettings& settings = inputs.settings;
    const EmitterTable& table = inputs.gpuScene.emitterTable;
    const bool local = settings.lighting != Lighting::Global;
    const bool samplesAreas = local && inputs.plan.areaLights && table.areaLightCount > 0;
    // Lights of no power are not in the table: from an empty one nothing can be chosen.
    const bool global = settings.lighting != Lighting::Local && inputs.plan.lightPaths && !table.emitters.empty() &&
                        settings.vplCount > 0 && settings.bounceCount.value_or(0) > 0;

    LightsOfFrame result;
    result.lightCount = (local ? table.deltaLightCount : 0) +
                        (samplesAreas ? lightSamplesOfPoint(settings.lightSampleCount, inputs.pointCount()) : 0);
    if (global) {
        result.vplCount = settings.vplCount;
        result.vpls = addVplEmission(graph, scene, inputs.plan,
                                     {.pathCount = settings.pathCount,
                                      .vplCount = settings.vplCount,
                                      .bounceCount = static_cast<uint32_t>(*settings.bounceCount),
                                      .russianRoulette = settings.russianRoulette});
    } else {
        result.vpls = addDarkVpls(graph, inputs.plan);
    }
    return result;
}

}  // namespace manylight
