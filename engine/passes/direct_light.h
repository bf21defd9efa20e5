// Emission the camera sees, and the light of the real lights on the G-buffer.
#pragma once

#include "engine/passes/gbuffer.h"

#include <optional>

namespace manylight {

struct DirectLightOptions {
    uint32_t lightCount = 0;  // point, spot and directional lights and samples of area lights
    bool castShadows = true;
    uint32_t candidates = 1;  // for every ray to an area light, drawn by what they would give without visibility
    bool areasApart = false;  // for a filter, which light that has no noise does not need
    std::optional<ImageHandle> radiance = std::nullopt;  // RGBA32F, to add to
};

struct DirectLight {
    ImageHandle radiance;  // RGBA32F: emission and direct light of the frame
    std::optional<ImageHandle>
        areaLight;  // RGBA32F: what is not in it, light of area lights, demodulated, and its standard error
};

DirectLight addDirectLight(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                           const DirectLightOptions& light, uint32_t width, uint32_t height);

}  // namespace manylight
