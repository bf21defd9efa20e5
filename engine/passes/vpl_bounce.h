// Light paths meet surfaces and leave vertices.
#pragma once

#include "engine/passes/gpu_scene.h"
#include "shaders/shared/vpl_emission.h"

namespace manylight {

/// What the paths of one batch are made of.
struct PathBuffers {
    BufferHandle rays;      // Ray per path
    BufferHandle offsets;   // vertices per path, then their prefix sum with the total behind it
    BufferHandle vertices;  // LightData, slot = (depth - 1) * paths + path
    BufferHandle gloss;     // VplGloss for each; a single one where the scene has no glossy surfaces
};

void addVplBounces(FrameGraph& graph, SceneHandles& scene, const gpu::Specialisation& surfaceOptions,
                   PathBuffers& paths, const shared::EmissionPush& push);

}  // namespace manylight
