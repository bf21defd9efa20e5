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
    const ImageHandle light = asksAll
                                  ? addVplLight(graph, scene, inputs.plan, gbuffer, lights.vpls, gather, radiance,
                                                settings.width, settings.height)
                                  : addSomeVpls(graph, scene, inputs, gbuffer, lights, false, false, radiance);
    return giveBack(graph, scene, inputs, gbuffer, lights, light, false);
}

/// Light of all kinds, demodulated, each filtered as suits it.
class FilteredLight {
  public:
    FilteredLight(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs, const GBuffer& gbuffer,
                  ImageHandle guide, const LightsOfFrame& lights)
        : graph_(graph), scene_(scene), inputs_(inputs), gbuffer_(gbuffer), guide_(guide), lights_(lights) {
        if (settings_.lighting != Lighting::Global) addDirect();
        if (lights.vplCount > 0 || !sum_) addIndirect();
    }
    ImageHandle sum() const { return *sum_; }

  private:
    void add(ImageHandle light) {
        sum_ = sum_ ? addReconstructSum(graph_, scene_, *sum_, light, settings_.width, settings_.height) : light;
    }

    /// Only what has noise is filtered: samples of area lights.
    void addDirect() {
        const ReconstructionSchedule schedule = areaLightSchedule(inputs_.frame);
        const bool samplesAreas = lights_.lightCount > inputs_.gpuScene.emitterTable.deltaLightCount;
        const DirectLight direct = addDirectLight(graph_, scene_, inputs_.plan, gbuffer_,
                                                  {.lightCount = lights_.lightCount,
                                                   .castShadows = settings_.castShadows,
                                                   .forReconstruction = true,
                                                   .areasApart = samplesAreas && schedule.filters()},
                                                  settings_.width, settings_.height);
        add(direct.radiance);
        if (direct.areaLight)
            add(addReconstruction(graph_, scene_, guide_, *direct.areaLight, schedule, 1, std::nullopt, settings_.width,
                                  settings_.height));
    }

    void addIndirect() {
        const ReconstructionSchedule schedule = scheduleOf(inputs_);
        const bool visibilityApart = settings_.filter == Filter::Ratio && resamples(settings_) && schedule.filters();
        ImageHandle light =
            addSomeVpls(graph_, scene_, inputs_, gbuffer_, lights_, true, visibilityApart, std::nullopt);
        // A filter may smooth what is given back too, but for one that takes shares of the light of VPLs.
        if (!visibilityApart) light = giveBack(graph_, scene_, inputs_, gbuffer_, lights_, light, true);
        add(addReconstruction(graph_, scene_, guide_, light, schedule, settings_.interleave,
                              visibilityApart ? std::optional(settings_.shadowRays) : std::nullopt, settings_.width,
                              settings_.height));
        if (visibilityApart) sum_ = giveBack(graph_, scene_, inputs_, gbuffer_, lights_, *sum_, true);
    }

    FrameGraph& graph_;
    SceneHandles& scene_;
    const FrameInputs& inputs_;
    const RenderSettings& settings_ = inputs_.settings;
    const GBuffer& gbuffer_;
    ImageHandle guide_;
    const LightsOfFrame& lights_;
    std::optional<ImageHandle> sum_;
};

/// Radiance at all points of the frame: light is found at the first, and borrowed by the others.
ImageHandle addFilteredRadiance(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs,
                                const GBuffer& gbuffer, const LightsOfFrame& lights) {
    const RenderSettings& settings = inputs.settings;
    const uint32_t width = settings.width;
    const uint32_t height = settings.height;
    const ImageHandle guide = addReconstructGuide(graph, scene, inputs.plan, gbuffer, width, height);
    const ImageHandle light = FilteredLight(graph, scene, inputs, gbuffer, guide, lights).sum();
    const bool showEmission = settings.lighting != Lighting::Global;
    const size_t last = inputs.points.size() - 1;
    ImageHandle radiance = addRemodulate(graph, scene, inputs.plan, gbuffer, light, std::nullopt, showEmission,
                                         last == 0, width, height);
    for (size_t i = 1; i <= last; ++i) {
        SceneHandles atPoint = scene;
        atPoint.frame = inputs.points[i].frameConstants;
        const GBuffer seen =
            addGBuffer(graph, atPoint, inputs.plan, inputs.gpuScene.draws, inputs.gbufferByRays, width, height);
        const LightToBorrow borrowed{guide, radiance, inputs.points[0].offset - inputs.points[i].offset};
        radiance = addRemodulate(graph, atPoint, inputs.plan, seen, light, borrowed, showEmission, i == last, width,
                                 height);
        scene.status = atPoint.status;
    }
    return radiance;
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
            radiance = addDirectLight(graph, scene, inputs.plan, gbuffer,
                                      {.lightCount = lights.lightCount, .castShadows = settings.castShadows}, width,
                                      height)
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
