// The first step of the reconstruction: the mean over a period of the interleaving.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

/// `gathered` and the result are RGBA32F: light, demodulated, and its standard error. `period` is that of the
/// subsets of VPLs, in pixels that have gathered; `width`, of the box, is in pixels, and n for the whole period.
ImageHandle addReconstructBlock(FrameGraph& graph, const SceneHandles& scene, ImageHandle guide, ImageHandle gathered,
                                float width, uint32_t period, uint32_t imageWidth, uint32_t imageHeight);

}  // namespace manylight
