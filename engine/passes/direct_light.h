// Emission the camera sees, and the light of the real lights on the G-buffer.
#pragma once

#include "engine/passes/gbuffer.h"

namespace manylight {

/// `lightCount`: point, spot and directional lights and samples of area lights. Returns the frame's radiance, RGBA32F,
/// with emission and direct light in it.
ImageHandle addDirectLight(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                           uint32_t lightCount, bool castShadows, uint32_t width, uint32_t height);

}  // namespace manylight
