// Geometry pass: rasterise which triangle each pixel sees, then look up its surface once per pixel.
#pragma once

#include "engine/passes/gpu_scene.h"

#include <span>

namespace manylight {

struct GBuffer {
    ImageHandle position;  // RGBA32_UINT: position bits, triangle + 1 (0: nothing seen)
    ImageHandle shading;   // RGBA32_UINT: octahedral normal as two floats, albedo with 21 bits a channel
    ImageHandle gloss;     // RGBA32_UINT: reflectance at normal incidence and alpha as floats; one texel if not needed
    ImageHandle depth;     // D32_SFLOAT, reversed: 1 at the near plane, 0 at infinity
};

GBuffer addGBuffer(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan,
                   std::span<const DrawRange> draws, uint32_t width, uint32_t height);

/// Declares that a compute pass reads it.
void readGBuffer(PassBuilder& pass, const GBuffer& gbuffer);

}  // namespace manylight
