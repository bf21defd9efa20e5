#include "engine/techniques/reconstruction.h"

#include "engine/passes/reconstruct_atrous.h"
#include "engine/passes/reconstruct_block.h"
#include "engine/passes/remodulate.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace manylight {
namespace {

float envf(const char* n, float d) { const char* v = std::getenv(n); return v ? std::strtof(v, nullptr) : d; }

constexpr uint32_t kFewestFramesOfACycle = 16;

}  // namespace

ReconstructionSchedule reconstructionSchedule(uint32_t interleave, uint32_t frame) {
    const float kDeviations = envf("F_DEV", 3.0f);
    const uint32_t kLevels = static_cast<uint32_t>(envf("F_LEVELS", 3.0f));
    const uint32_t cycle = std::max(interleave * interleave, kFewestFramesOfACycle);
    const double share = std::min(1.0, static_cast<double>(cycle) / (frame + 1.0));
    const auto shrunk = static_cast<float>(std::pow(share, envf("F_POW", 1.0f / 6.0f)));
    ReconstructionSchedule schedule;
    schedule.blockWidth = std::max(1.0f, static_cast<float>(interleave) * shrunk);
    const uint32_t finest = std::max(interleave / 2, 1u);
    for (uint32_t level = 0; level < kLevels; ++level) {
        const float reach = static_cast<float>(finest << level) * shrunk;
        if (reach >= 1.0f)
            schedule.levels.push_back({static_cast<uint32_t>(std::lround(reach)), kDeviations * shrunk});
    }
    return schedule;
}

ImageHandle addReconstruction(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan,
                              const GBuffer& gbuffer, ImageHandle gathered, std::optional<ImageHandle> radiance,
                              uint32_t interleave, uint32_t frame, uint32_t width, uint32_t height) {
    const ReconstructionSchedule schedule = reconstructionSchedule(interleave, frame);
    ImageHandle light = gathered;
    if (schedule.blockWidth > 1.0f)
        light = addReconstructBlock(graph, scene, plan, gbuffer, light, schedule.blockWidth, interleave, width, height);
    for (const ReconstructionStep& level : schedule.levels)
        light = addReconstructAtrous(graph, scene, plan, gbuffer, light, level.spacing, level.deviations, width, height);
    return addRemodulate(graph, scene, plan, gbuffer, light, radiance, width, height);
}

}  // namespace manylight
