// What filters read of the G-buffer.
#pragma once

#include "engine/passes/gbuffer.h"

namespace manylight {

/// RGBA32F: normal, and depth along the camera's axis; 0 where a pixel shares light with no neighbour.
ImageHandle addReconstructGuide(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan,
                                const GBuffer& gbuffer, uint32_t width, uint32_t height);

}  // namespace manylight
