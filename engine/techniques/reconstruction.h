// The filter after an interleaved or resampled gather, pass by pass, and how it fades as frames come in.
#pragma once

#include "engine/passes/gpu_scene.h"

#include <optional>
#include <vector>

namespace manylight {

/// What the filter does in one frame.
struct ReconstructionStep {
    uint32_t spacing;  // of the taps, pixels
    float deviations;
};
struct ReconstructionSchedule {
    float blockWidth = 1.0f;  // pixels; 1: the pixel alone
    uint32_t gatherStep = 1;  // every so many pixels gather, the others borrow; only where the block is whole
    std::vector<ReconstructionStep> levels;

    bool filters() const { return blockWidth > 1.0f || !levels.empty(); }
};

/// The whole filter for the first frame; then its radius falls with the sixth root of their number, which balances bias
/// and variance as in progressive photon mapping [KaplanyanDachsbacher2013]. In the end nothing is filtered. The box
/// stays whole for four frames, as any other shows a pattern of the period until frames have averaged it; where only
/// every `gatherStep`-th pixel gathers, so does the rest. `frame`: how many there were before.
ReconstructionSchedule reconstructionSchedule(uint32_t interleave, uint32_t gatherStep, uint32_t frame);

/// Of light of area lights, whose samples neighbours draw independently: one level of the nearest pixels. Measured:
/// with a second one shadows lose more than noise does. It fades by what may mix, and is gone after 64 frames.
ReconstructionSchedule areaLightSchedule(uint32_t frame);

/// What --gather-step comes to: the largest number up to it that divides the period.
uint32_t effectiveGatherStep(uint32_t interleave, uint32_t gatherStep);

/// At how many points of a pixel a frame asks what is seen. Those but the first borrow light, which biases: they come
/// to an end, and what they did fades with the mean over frames.
uint32_t visibilitySamples(uint32_t asked, uint32_t frame);

/// Samples of area lights at each of so many points: together no fewer than were asked for.
uint32_t lightSamplesOfPoint(uint32_t asked, uint32_t pointCount);

/// Number of such a point (0: where light is found) in the sequence that all points of all frames come from. Which
/// place of its frame is first is left to chance, or light would be found in one part of the pixel only.
uint32_t numberOfPoint(uint32_t pointCount, uint32_t frame, uint32_t point);

/// Light of `gathered` (RGBA32F, of addVplResample() for reconstruction, or of addDirectLight() apart), filtered.
/// `guide`: of addReconstructGuide(). `raysApart`: of a pixel, where `gathered` has visibility apart; otherwise none.
ImageHandle addReconstruction(FrameGraph& graph, const SceneHandles& scene, ImageHandle guide, ImageHandle gathered,
                              const ReconstructionSchedule& schedule, uint32_t interleave,
                              std::optional<uint32_t> raysApart, uint32_t width, uint32_t height);

}  // namespace manylight
