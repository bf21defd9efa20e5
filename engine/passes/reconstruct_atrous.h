// One level of the edge-avoiding a-trous wavelet.
#pragma once

#include "engine/passes/gbuffer.h"

namespace manylight {

/// `light` and the result are RGBA32F: light, demodulated, and its standard error. Taps are `spacing` pixels apart, 5 x 5
/// of them; pixels of one surface differ by up to some `deviations` times that error.
ImageHandle addReconstructAtrous(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan,
                                 const GBuffer& gbuffer, ImageHandle light, uint32_t spacing, float deviations,
                                 uint32_t width, uint32_t height);

}  // namespace manylight
