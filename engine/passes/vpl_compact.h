// From path vertices in their slots to a dense VPL list: prefix sum, then each list entry fetches its vertex.
#pragma once

#include "engine/passes/vpl_bounce.h"

namespace manylight {

/// Adds the batch's share to `vpls` and returns the new version.
BufferHandle addVplCompact(FrameGraph& graph, SceneHandles& scene, PathBuffers& paths, BufferHandle vpls,
                           const shared::EmissionPush& push);

}  // namespace manylight
