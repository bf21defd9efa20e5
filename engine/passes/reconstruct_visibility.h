// The first and the last step of the reconstruction by visibility.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

struct UnshadowedAndVisibility {
    ImageHandle unshadowed;  // RGBA32F: light, demodulated, as if nothing were between
    ImageHandle visibility;  // RGBA32F: the share of it that arrives, and its standard error
};

/// `gathered`, RGBA32F, is of addVplResample() with visibility apart. `width` and `period` as of addReconstructBlock();
/// `rays` of a pixel.
UnshadowedAndVisibility addReconstructVisibility(FrameGraph& graph, const SceneHandles& scene, ImageHandle guide,
                                                 ImageHandle gathered, float width, uint32_t period, uint32_t rays,
                                                 uint32_t imageWidth, uint32_t imageHeight);

/// Both multiplied: light, RGBA32F.
ImageHandle addReconstructProduct(FrameGraph& graph, const SceneHandles& scene, const UnshadowedAndVisibility& factors,
                                  uint32_t width, uint32_t height);

}  // namespace manylight
