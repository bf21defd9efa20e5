// What the camera sees of an environment's map behind a forward picture.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

/// Fills the pixels of `radiance` (RGBA32F) whose alpha is zero, which becomes one.
ImageHandle addBackground(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, ImageHandle radiance,
                          uint32_t width, uint32_t height);

}  // namespace manylight
