// The VPLs themselves, drawn into the picture as dots of their colour.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

/// Draws over `radiance` where `depth` does not hide them. `radius` in pixels; the dots' radiance is `brightness`.
ImageHandle addShowVpls(FrameGraph& graph, const SceneHandles& scene, BufferHandle vpls, uint32_t vplCount,
                        ImageHandle radiance, ImageHandle depth, float radius, float brightness);

}  // namespace manylight
