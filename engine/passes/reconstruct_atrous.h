// One level of the edge-avoiding a-trous wavelet.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

/// `light` and the result are RGBA32F: light, demodulated, and its standard error. Taps are `spacing` pixels apart, 5 x
/// 5 of them; pixels of one surface differ by up to some `deviations` times that error.
ImageHandle addReconstructAtrous(FrameGraph& graph, const SceneHandles& scene, ImageHandle guide, ImageHandle light,
                                 uint32_t spacing, float deviations, uint32_t width, uint32_t height);

}  // namespace manylight
