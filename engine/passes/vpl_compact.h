// From path vertices in their slots to a dense VPL list: prefix sum, then each list entry fetches its vertex.
#pragma once

#include "engine/passes/vpl_bounce.h"
#include "engine/passes/vpl_buffers.h"

namespace manylight {

/// Adds the batch's share to `vpls` and returns the new version.
VplBuffers addVplCompact(FrameGraph& graph, SceneHandles& scene, const gpu::Specialisation& surfaceOptions,
                         PathBuffers& paths, VplBuffers vpls, const shared::EmissionPush& push);

}  // namespace manylight
