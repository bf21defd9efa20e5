// The light that the bound on the geometry term takes from the VPLs, given back by short paths (Kollig and Keller
// 2006).
#pragma once

#include "engine/passes/gbuffer.h"
#include "engine/passes/vpl_buffers.h"

namespace manylight {

/// Adds to `image` and returns its new version: radiance or, `forReconstruction`, the light that addVplResample() gathered
/// for a filter. `vpls`: the list that the gather reads.
ImageHandle addCompensation(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                            const VplBuffers& vpls, ImageHandle image, bool forReconstruction, uint32_t width,
                            uint32_t height);

}  // namespace manylight
