// Emission the camera sees, and the light of the real lights on the G-buffer.
#pragma once

#include "engine/passes/gbuffer.h"

#include <optional>

namespace manylight {

struct DirectLight {
    ImageHandle radiance;  // RGBA32F: emission and direct light of the frame
    std::optional<ImageHandle>
        areaLight;  // RGBA32F: what is not in it, light of area lights, demodulated, and its standard error
};

/// `lightCount`: point, spot and directional lights and samples of area lights. `keepsAreasApart`: for a filter, of
/// which light that has no noise needs none.
DirectLight addDirectLight(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                           uint32_t lightCount, bool castShadows, bool keepsAreasApart, uint32_t width,
                           uint32_t height);

}  // namespace manylight
