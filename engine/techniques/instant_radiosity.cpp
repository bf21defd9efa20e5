#include "engine/techniques/instant_radiosity.h"

#include "engine/passes/compensation.h"
#include "engine/passes/direct_light.h"
#include "engine/passes/reconstruct_guide.h"
#include "engine/passes/reconstruct_sum.h"
#include "engine/passes/remodulate.h"
#include "engine/passes/show_gbuffer.h"
#include "engine/passes/show_rays.h"
#include "engine/passes/vpl_light.h"
#include "engine/passes/vpl_resample.h"
#include "engine/techniques/lights_of_frame.h"
#include "engine/techniques/reconstruction.h"

#include <optional>

namespace manylight {
namespace {

// Measured: a second one takes a sixth of the error of direct light from lamps as large as those of the classroom, for
// a fifth more time; a lamp as small as the Cornell box's has nothing from it. Four are hardly better than two.
constexpr uint32_t kAreaCandidates = 2;

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

ReconstructionSchedule scheduleOf(const FrameInputs& inputs) {
    const RenderSettings& settings = inputs.settings;
    if (!filters(settings)) return {};
    return reconstructionSchedule(settings.interleave, settings.gatherStep, inputs.frame);
}

/// What the bound cuts off, added to `image`.
ImageHandle giveBack(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs, const GBuffer& gbuffer,
                     const LightsOfFrame& lights, ImageHandle image, bool forReconstruction) {
    const RenderSettings& settings = inputs.settings;
    if (lights.vplCount == 0 || settings.clamp != ClampMode::Compensate) return image;
    return addCompensation(graph, scene, inputs.plan, gbuffer, lights.vpls, image, forReconstruction, settings.width,
                           settings.height);
}

/// Some of the VPLs for every pixel: the mean is that of all.
ImageHandle addSomeVpls(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs, const GBuffer& gbuffer,
                        const LightsOfFrame& lights, bool forReconstruction, bool visibilityApart,
                        std::optional<ImageHandle> radiance) {
    const RenderSettings& settings = inputs.settings;
    const ReconstructionSchedule schedule = scheduleOf(inputs);
    const GatherGrid grid = gatherGrid(schedule.gatherStep, inputs.frame);
    return addVplResample(graph, scene, inputs.plan, gbuffer, lights.vpls,
                          {.vplCount = lights.vplCount,
                           .castShadows = settings.castShadows,
                           .shadowRays = resamples(settings) ? settings.shadowRays : 0,
                           .interleave = settings.interleave,
                           .phase = settings.interleavePhase + grid.turn,
                           .subgroupSize = inputs.subgroupSize,
                           .forReconstruction = forReconstruction,
                           .visibilityApart = visibilityApart,
                           .gatherStep = schedule.gatherStep,
                           .gridStart = grid.start},
                          radiance, settings.width, settings.height);
}

/// Every pixel from every VPL, or from some of them, with what the bound cut off, if asked for.
ImageHandle addGather(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs, const GBuffer& gbuffer,
                      const LightsOfFrame& lights, const VplLightOptions& gather, std::optional<ImageHandle> radiance) {
    const RenderSettings& settings = inputs.settings;
    const bool asksAll = settings.interleave == 1 && !resamples(settings);
    const ImageHandle light = asksAll ? addVplLight(graph, scene, inputs.plan, gbuffer, lights.vpls, gather, radiance,
                                                    settings.width, settings.height)
                                      : addSomeVpls(graph, scene, inputs, gbuffer, lights, false, false, radiance);
    return giveBack(graph, scene, inputs, gbuffer, lights, light, false);
}

/// Filtered light of the VPLs, demodulated, with what the bound cut off.
ImageHandle addFilteredGather(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs, const GBuffer& gbuffer,
                              ImageHandle guide, const LightsOfFrame& lights) {
    const RenderSettings& settings = inputs.settings;
    const ReconstructionSchedule schedule = scheduleOf(inputs);
    const bool visibilityApart = settings.filter == Filter::Ratio && resamples(settings) && schedule.filters();
    ImageHandle light = addSomeVpls(graph, scene, inputs, gbuffer, lights, true, visibilityApart, std::nullopt);
    // A filter may smooth what is given back too, but for one that takes shares of the light of VPLs.
    if (!visibilityApart) light = giveBack(graph, scene, inputs, gbuffer, lights, light, true);
    light = addReconstruction(graph, scene, guide, light, schedule, settings.interleave,
                              visibilityApart ? std::optional(settings.shadowRays) : std::nullopt, settings.width,
                              settings.height);
    return visibilityApart ? giveBack(graph, scene, inputs, gbuffer, lights, light, true) : light;
}

/// Emission and direct light at one point of all pixels: light that has noise apart, filtered and demodulated.
DirectLight addFilteredDirect(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs, const GBuffer& gbuffer,
                              ImageHandle guide, const LightsOfFrame& lights, std::optional<ImageHandle> radiance) {
    const RenderSettings& settings = inputs.settings;
    const ReconstructionSchedule schedule = areaLightSchedule(inputs.frame);
    const bool samplesAreas = lights.lightCount > inputs.gpuScene.emitterTable.deltaLightCount;
    DirectLight direct = addDirectLight(graph, scene, inputs.plan, gbuffer,
                                        {.lightCount = lights.lightCount,
                                         .castShadows = settings.castShadows,
                                         .candidates = kAreaCandidates,
                                         .areasApart = samplesAreas && schedule.filters(),
                                         .radiance = radiance},
                                        settings.width, settings.height);
    if (direct.areaLight)
        direct.areaLight = addReconstruction(graph, scene, guide, *direct.areaLight, schedule, 1, std::nullopt,
                                             settings.width, settings.height);
    return direct;
}

/// The mean over the points at which the frame sees pixels. VPLs are asked at the first; the others borrow their light.
ImageHandle addFilteredRadiance(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs,
                                const GBuffer& gbuffer, const LightsOfFrame& lights) {
    const RenderSettings& settings = inputs.settings;
    const uint32_t width = settings.width;
    const uint32_t height = settings.height;
    const bool hasDirect = settings.lighting != Lighting::Global;
    const ImageHandle guide = addReconstructGuide(graph, scene, inputs.plan, gbuffer, width, height);
    std::optional<ImageHandle> ofVpls;
    if (lights.vplCount > 0 || !hasDirect) ofVpls = addFilteredGather(graph, scene, inputs, gbuffer, guide, lights);
    std::optional<ImageHandle> radiance;
    const uint32_t last = inputs.pointCount() - 1;
    for (uint32_t i = 0; i <= last; ++i) {
        const bool isFirst = i == 0;
        SceneHandles atPoint = scene;
        if (!isFirst) atPoint.frame = inputs.points[i].frameConstants;
        const GBuffer seen = isFirst ? gbuffer
                                     : addGBuffer(graph, atPoint, inputs.plan, inputs.gpuScene.draws,
                                                  inputs.gbufferByRays, width, height);
        std::optional<ImageHandle> own;
        if (hasDirect) {
            const ImageHandle itsGuide =
                isFirst ? guide : addReconstructGuide(graph, atPoint, inputs.plan, seen, width, height);
            const DirectLight direct = addFilteredDirect(graph, atPoint, inputs, seen, itsGuide, lights, radiance);
            radiance = direct.radiance;
            own = direct.areaLight;
        }
        std::optional<LentLight> lent;
        if (ofVpls && isFirst)
            own = own ? addReconstructSum(graph, atPoint, *own, *ofVpls, width, height) : *ofVpls;
        else if (ofVpls)
            lent = {*ofVpls, guide, inputs.points[0].offset - inputs.points[i].offset};
        const float scale = i < last ? 1.0f : 1.0f / static_cast<float>(last + 1);
        if (own || lent || scale != 1.0f)
            radiance = addRemodulate(graph, atPoint, inputs.plan, seen, own, lent, radiance, scale, width, height);
        scene.status = atPoint.status;
    }
    return *radiance;
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
    VplLightOptions gather{.vplCount = lights.vplCount,
                           .castShadows = settings.castShadows,
                           .subgroupSize = inputs.subgroupSize,
                           .pixelsPerInvocation = inputs.pixelsPerInvocation};
    std::optional<ImageHandle> radiance;
    if (filters(settings)) {
        radiance = addFilteredRadiance(graph, scene, inputs, gbuffer, lights);
    } else {
        if (settings.lighting != Lighting::Global)
            radiance =
                addDirectLight(graph, scene, inputs.plan, gbuffer,
                               {.lightCount = lights.lightCount, .castShadows = settings.castShadows}, width, height)
                    .radiance;
        if (lights.vplCount > 0 || !radiance)
            radiance = addGather(graph, scene, inputs, gbuffer, lights, gather, radiance);
    }
    TechniqueResult result{*radiance, gbuffer.depth, lights.list(), std::nullopt, gbuffer};
    if (inputs.keepsCutOff) {
        gather.cutOff = true;
        result.cutOff =
            addVplLight(graph, scene, inputs.plan, gbuffer, lights.vpls, gather, std::nullopt, width, height);
    }
    return result;
}

}  // namespace manylight
