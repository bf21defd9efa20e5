// Geometry pass: find which triangle each pixel sees, by the rasteriser or by rays, then look up its surface once per
// pixel.
#pragma once

#include "engine/passes/gpu_scene.h"

#include <optional>
#include <span>

namespace manylight {

struct GBuffer {
    ImageHandle position;  // RGBA32_UINT: position bits, triangle + 1 (0: nothing seen)
    ImageHandle shading;   // RGBA32_UINT: octahedral normal as two floats, albedo with 21 bits a channel
    ImageHandle gloss;     // RGBA32_UINT: reflectance at normal incidence and alpha as floats; one texel if not needed
    std::optional<ImageHandle> depth;  // D32_SFLOAT, reversed: 1 at the near plane, 0 at infinity; rays leave none
};

GBuffer addGBuffer(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, std::span<const DrawRange> draws,
                   bool byRays, uint32_t width, uint32_t height);

/// Declares that a compute pass reads it.
void readGBuffer(PassBuilder& pass, const GBuffer& gbuffer);

}  // namespace manylight
