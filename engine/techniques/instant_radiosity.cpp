#include "engine/techniques/instant_radiosity.h"

#include "engine/passes/compensation.h"
#include "engine/passes/direct_light.h"
#include "engine/passes/reconstruct_guide.h"
#include "engine/passes/show_gbuffer.h"
#include "engine/passes/show_rays.h"
#include "engine/passes/vpl_light.h"
#include "engine/passes/vpl_resample.h"
#include "engine/techniques/lights_of_frame.h"
#include "engine/techniques/reconstruction.h"

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

/// Where the grid of the pixels that gather begins, and how often a pixel of it has gathered: it meets another subset
/// each time.
struct GatherGrid {
    glm::uvec2 start;
    uint32_t turn;
};
GatherGrid gatherGrid(uint32_t step, uint32_t frame) {
    const uint32_t place = frame % (step * step);
    return {{place % step, place / step}, frame / (step * step)};
}

bool resamples(const RenderSettings& settings) { return settings.castShadows && settings.shadowRays > 0; }

/// A filter follows interleaved gathers and those of few rays.
bool filters(const RenderSettings& settings) {
    return settings.filter != Filter::Off && (settings.interleave > 1 || resamples(settings));
}

ReconstructionSchedule scheduleOf(const FrameInputs& inputs) {
    const RenderSettings& settings = inputs.settings;
    if (!filters(settings)) return {};
    return reconstructionSchedule(settings.interleave, settings.gatherStep, inputs.frame);
}

/// With a guide, what samples of area lights say is filtered.
ImageHandle addFilteredDirectLight(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs,
                                   const GBuffer& gbuffer, std::optional<ImageHandle> guide,
                                   const LightsOfFrame& lights) {
    const RenderSettings& settings = inputs.settings;
    const ReconstructionSchedule schedule = areaLightSchedule(inputs.frame);
    const bool samplesAreas = lights.lightCount > inputs.gpuScene.emitterTable.deltaLightCount;
    const bool isFiltered = guide && samplesAreas && schedule.filters();
    const DirectLight direct = addDirectLight(graph, scene, inputs.plan, gbuffer, lights.lightCount,
                                              settings.castShadows, isFiltered, settings.width, settings.height);
    if (!isFiltered) return direct.radiance;
    return addReconstruction(graph, scene, inputs.plan, gbuffer, *guide, *direct.areaLight, direct.radiance, schedule,
                             1, std::nullopt, settings.width, settings.height);
}

/// What the bound cuts off, added to `image`.
ImageHandle giveBack(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs, const GBuffer& gbuffer,
                     const LightsOfFrame& lights, ImageHandle image, bool forReconstruction) {
    const RenderSettings& settings = inputs.settings;
    if (lights.vplCount == 0 || settings.clamp != ClampMode::Compensate) return image;
    return addCompensation(graph, scene, inputs.plan, gbuffer, lights.vpls, image, forReconstruction, settings.width,
                           settings.height);
}

/// Every pixel from every VPL, or from some of them: the mean is the same. With what the bound cut off, if asked for.
ImageHandle addGather(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs, const GBuffer& gbuffer,
                      std::optional<ImageHandle> guide, const LightsOfFrame& lights, const VplLightOptions& gather,
                      std::optional<ImageHandle> radiance) {
    const RenderSettings& settings = inputs.settings;
    if (settings.interleave == 1 && !resamples(settings)) {
        const ImageHandle light = addVplLight(graph, scene, inputs.plan, gbuffer, lights.vpls, gather, radiance,
                                              settings.width, settings.height);
        return giveBack(graph, scene, inputs, gbuffer, lights, light, false);
    }
    const bool isFiltered = guide.has_value();
    const ReconstructionSchedule schedule = scheduleOf(inputs);
    const bool visibilityApart = settings.filter == Filter::Ratio && resamples(settings) && schedule.filters();
    const GatherGrid grid = gatherGrid(schedule.gatherStep, inputs.frame);
    ImageHandle gathered = addVplResample(graph, scene, inputs.plan, gbuffer, lights.vpls,
                                          {.vplCount = lights.vplCount,
                                           .castShadows = settings.castShadows,
                                           .shadowRays = resamples(settings) ? settings.shadowRays : 0,
                                           .interleave = settings.interleave,
                                           .phase = settings.interleavePhase + grid.turn,
                                           .subgroupSize = inputs.subgroupSize,
                                           .forReconstruction = isFiltered,
                                           .visibilityApart = visibilityApart,
                                           .gatherStep = schedule.gatherStep,
                                           .gridStart = grid.start},
                                          isFiltered ? std::nullopt : radiance, settings.width, settings.height);
    // A filter may smooth what is given back too, but for one that takes shares of the light of VPLs.
    if (!visibilityApart) gathered = giveBack(graph, scene, inputs, gbuffer, lights, gathered, isFiltered);
    if (!isFiltered) return gathered;
    const ImageHandle light = addReconstruction(
        graph, scene, inputs.plan, gbuffer, *guide, gathered, radiance, schedule, settings.interleave,
        visibilityApart ? std::optional(settings.shadowRays) : std::nullopt, settings.width, settings.height);
    return visibilityApart ? giveBack(graph, scene, inputs, gbuffer, lights, light, false) : light;
}

}  // namespace

TechniqueResult declareInstantRadiosity(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs) {
    const RenderSettings& settings = inputs.settings;
    const uint32_t width = settings.width;
    const uint32_t height = settings.height;
    const GBuffer gbuffer =
        addGBuffer(graph, scene, inputs.plan, inputs.gpuScene.draws, inputs.gbufferByRays, width, height);
    if (const auto channel = channelShown(settings.show))
        return {addShowGBuffer(graph, scene, inputs.plan, gbuffer, *channel, 0.5f / inputs.gpuScene.sphere.radius,
                               width, height),
                gbuffer.depth, std::nullopt};

    const LightsOfFrame lights = addLightsOfFrame(graph, scene, inputs);
    if (settings.show == Show::Rays) {
        const ReconstructionSchedule schedule = scheduleOf(inputs);
        const GatherGrid grid = gatherGrid(schedule.gatherStep, inputs.frame);
        return {addShowRays(graph, scene, inputs.plan, gbuffer, lights.vpls,
                            {.vplCount = lights.vplCount,
                             .shadowRays = settings.castShadows ? settings.shadowRays : 0,
                             .interleave = settings.interleave,
                             .phase = settings.interleavePhase + grid.turn,
                             .subgroupSize = inputs.subgroupSize,
                             .gatherStep = schedule.gatherStep,
                             .gridStart = grid.start},
                            width, height),
                gbuffer.depth, lights.list()};
    }
    std::optional<ImageHandle> guide;
    if (filters(settings)) guide = addReconstructGuide(graph, scene, inputs.plan, gbuffer, width, height);
    std::optional<ImageHandle> radiance;
    if (settings.lighting != Lighting::Global)
        radiance = addFilteredDirectLight(graph, scene, inputs, gbuffer, guide, lights);
    VplLightOptions gather{.vplCount = lights.vplCount,
                           .castShadows = settings.castShadows,
                           .subgroupSize = inputs.subgroupSize,
                           .pixelsPerInvocation = inputs.pixelsPerInvocation};
    if (lights.vplCount > 0 || !radiance)
        radiance = addGather(graph, scene, inputs, gbuffer, guide, lights, gather, radiance);
    TechniqueResult result{*radiance, gbuffer.depth, lights.list(), std::nullopt, gbuffer};
    if (inputs.keepsCutOff) {
        gather.cutOff = true;
        result.cutOff =
            addVplLight(graph, scene, inputs.plan, gbuffer, lights.vpls, gather, std::nullopt, width, height);
    }
    return result;
}

}  // namespace manylight
