// Every pixel of the G-buffer gathers from every VPL.
#pragma once

#include "engine/passes/gbuffer.h"
#include "engine/passes/vpl_buffers.h"

#include <optional>

namespace manylight {

struct VplLightOptions {
    uint32_t vplCount = 0;
    bool castShadows = true;  // a ray for every pair that could see each other
    uint32_t subgroupSize = 32;
    uint32_t pixelsPerInvocation = 4;  // without shadows; a matter of speed, the picture is the same
    bool cutOff = false;               // not the light of the VPLs, but what the bound takes from it
};

/// Adds indirect light to `radiance`, or starts a radiance image where there is none. Returns the new version.
ImageHandle addVplLight(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                        const VplBuffers& vpls, const VplLightOptions& options, std::optional<ImageHandle> radiance,
                        uint32_t width, uint32_t height);

}  // namespace manylight
