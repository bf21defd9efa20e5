// One channel of the G-buffer as a picture.
#pragma once

#include "engine/passes/gbuffer.h"
#include "shaders/shared/show.h"

namespace manylight {

/// `channel` is one of shared::kShow...; depth is scaled by `depthScale`, position by the scene's bounding sphere.
ImageHandle addShowGBuffer(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                           uint32_t channel, float depthScale, uint32_t width, uint32_t height);

}  // namespace manylight
