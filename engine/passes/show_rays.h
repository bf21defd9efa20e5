// How many shadow rays a pixel asks for, as a heat map.
#pragma once

#include "engine/passes/gbuffer.h"
#include "engine/passes/vpl_buffers.h"

namespace manylight {

struct ShowRaysOptions {
    uint32_t vplCount = 0;
    uint32_t shadowRays = 0;  // as VplResampleOptions have them
    uint32_t interleave = 1;
    uint32_t phase = 0;
    uint32_t subgroupSize = 32;
    uint32_t gatherStep = 1;
    glm::uvec2 gridStart{0};
};

/// Rays to VPLs that the gather would send from every pixel, over the number of VPLs, from black over red and yellow to
/// white: the channels' sum is three times that share, and so is their mean over frames.
ImageHandle addShowRays(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                        const VplBuffers& vpls, const ShowRaysOptions& options, uint32_t width, uint32_t height);

}  // namespace manylight
