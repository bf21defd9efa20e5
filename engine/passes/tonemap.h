// Post-processing: exposure, tone curve, display encoding.
#pragma once

#include "engine/passes/gpu_scene.h"
#include "shaders/shared/tonemap.h"

namespace manylight {

/// Writes sRGB bytes of `scale * sum` to `display` (RGBA8_UNORM). `curve` is one of shared::kTone....
ImageHandle addTonemap(FrameGraph& graph, const SceneHandles& scene, ImageHandle sum, ImageHandle display, float scale,
                       uint32_t curve, uint32_t width, uint32_t height);

}  // namespace manylight
