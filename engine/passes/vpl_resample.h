// Every pixel of the G-buffer gathers from a subset of the VPLs, with rays for some of them: the mean is that of
// addVplLight().
#pragma once

#include "engine/passes/gbuffer.h"
#include "engine/passes/vpl_buffers.h"

#include <optional>

namespace manylight {

struct VplResampleOptions {
    uint32_t vplCount = 0;
    bool castShadows = true;
    uint32_t shadowRays = 0;  // of a pixel for all VPLs of its subset, drawn by what they would give; 0: one for each
    uint32_t interleave = 1;  // n: a pixel gathers from one VPL in n * n, neighbours from others
    uint32_t phase = 0;       // which one: n * n phases in a row cover the list
    uint32_t subgroupSize = 32;
    bool forReconstruction = false;  // leaves light for addReconstruction() instead of radiance
    uint32_t gatherStep = 1;  // for reconstruction: one pixel in so many along x and y gathers, and those unlike it
    glm::uvec2 gridStart{0};  // where that grid begins
};

/// As addVplLight(); unbiased over phases, and over frames for any number of rays.
ImageHandle addVplResample(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                           const VplBuffers& vpls, const VplResampleOptions& options,
                           std::optional<ImageHandle> radiance, uint32_t width, uint32_t height);

}  // namespace manylight
