#include "engine/techniques/reconstruction.h"

#include "engine/passes/reconstruct_atrous.h"
#include "engine/passes/reconstruct_block.h"
#include "engine/passes/reconstruct_visibility.h"
#include "shaders/shared/sobol.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

constexpr float kDeviations = 3.0f;  // of irradiance, as far as its scatter tells: farther apart, pixels do not mix
constexpr uint32_t kMostLevels = 3;
constexpr uint32_t kWidestSpacing = 8;   // of taps, pixels; measured: where it is more, blur costs more than noise
constexpr float kLeastAreaShare = 0.5f;  // of the radius, which is two pixels
constexpr uint32_t kFramesWithMorePoints = 16;
constexpr uint32_t kFramesOfWholeBox = 4;

/// 1 for the first `wholeFrames`. Measured, n = 8: with one of the wavelet the least error after 8 s in three of four
/// rooms.
float shareOfRadius(uint32_t frame, uint32_t wholeFrames = 1) {
    return static_cast<float>(std::pow(std::min(1.0, wholeFrames / (frame + 1.0)), 1.0 / 6.0));
}

}  // namespace

uint32_t effectiveGatherStep(uint32_t interleave, uint32_t gatherStep) {
    uint32_t step = std::min(gatherStep, interleave);
    while (interleave % step != 0) --step;
    return step;
}

ReconstructionSchedule reconstructionSchedule(uint32_t interleave, uint32_t gatherStep, uint32_t frame) {
    const uint32_t step = effectiveGatherStep(interleave, gatherStep);
    const uint32_t wholeFrames = step > 1 ? kFramesOfWholeBox : 1;
    const float shrunk = shareOfRadius(frame, wholeFrames);
    ReconstructionSchedule schedule;
    schedule.blockWidth = std::max(1.0f, static_cast<float>(interleave) * shareOfRadius(frame, kFramesOfWholeBox));
    if (frame < wholeFrames) schedule.gatherStep = step;
    const uint32_t finest = std::max(interleave / 2, 1u);
    for (uint32_t level = 0; level < kMostLevels; ++level) {
        if (level > 0 && finest << level > kWidestSpacing) break;
        const float reach = static_cast<float>(finest << level) * shrunk;
        if (reach >= 1.0f) schedule.levels.push_back({static_cast<uint32_t>(std::lround(reach)), kDeviations * shrunk});
    }
    return schedule;
}

ReconstructionSchedule areaLightSchedule(uint32_t frame) {
    const float shrunk = shareOfRadius(frame);
    ReconstructionSchedule schedule;
    if (shrunk >= kLeastAreaShare) schedule.levels.push_back({1, kDeviations * shrunk});
    return schedule;
}

uint32_t visibilitySamples(uint32_t asked, uint32_t frame) { return frame < kFramesWithMorePoints ? asked : 1; }

uint32_t lightSamplesOfPoint(uint32_t asked, uint32_t pointCount) { return (asked + pointCount - 1) / pointCount; }

uint32_t numberOfPoint(uint32_t pointCount, uint32_t frame, uint32_t point) {
    return frame * pointCount + (point + shared::hashInteger(frame)) % pointCount;
}

ImageHandle addReconstruction(FrameGraph& graph, const SceneHandles& scene, ImageHandle guide, ImageHandle gathered,
                              const ReconstructionSchedule& schedule, uint32_t interleave,
                              std::optional<uint32_t> raysApart, uint32_t width, uint32_t height) {
    ImageHandle light = gathered;
    if (!schedule.filters()) return light;
    const uint32_t period = interleave / schedule.gatherStep;
    UnshadowedAndVisibility factors;
    if (raysApart)
        factors = addReconstructVisibility(graph, scene, guide, gathered, schedule.blockWidth, period, *raysApart,
                                           width, height);
    else if (schedule.blockWidth > 1.0f)
        light = addReconstructBlock(graph, scene, guide, gathered, schedule.blockWidth, period, width, height);
    ImageHandle& filtered = raysApart ? factors.visibility : light;
    for (const ReconstructionStep& level : schedule.levels)
        filtered = addReconstructAtrous(graph, scene, guide, filtered, level.spacing, level.deviations, width, height);
    return raysApart ? addReconstructProduct(graph, scene, factors, width, height) : light;
}

}  // namespace manylight
