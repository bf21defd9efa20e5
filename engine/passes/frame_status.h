// The counters of a frame: cleared before it, read by the host after it.
#pragma once

#include "engine/passes/gpu_scene.h"
#include "shaders/shared/lights.h"

namespace manylight {

PhysicalBuffer makeStatusBuffer(gpu::Device& device);
void addStatusReset(FrameGraph& graph, SceneHandles& scene);
void addStatusReadback(FrameGraph& graph, SceneHandles& scene);
/// After the frame has run.
shared::FrameStatus readStatus(const PhysicalBuffer& status);

}  // namespace manylight
