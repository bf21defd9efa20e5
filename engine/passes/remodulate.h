// The last step of the reconstruction: from light to radiance.
#pragma once

#include "engine/passes/gbuffer.h"

#include <glm/vec2.hpp>

#include <optional>

namespace manylight {

/// Where light is known, for a further point of all pixels that borrows it; RGBA32F both.
struct LightToBorrow {
    ImageHandle guide;     // of addReconstructGuide()
    ImageHandle radiance;  // sum over the points before, and their number in alpha
    glm::vec2 offset;      // from this point to that where light is known, pixels
};

/// Multiplies `light` (RGBA32F) by what the receivers in `gbuffer` reflect of it. Returns the sum over points of a pixel
/// or, at the last one, their mean; points where nobody around knows the light of their surface are left out. `scene`: with
/// frame constants of the point. `showEmission`: with what the camera sees of the lights themselves.
ImageHandle addRemodulate(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                          ImageHandle light, const std::optional<LightToBorrow>& borrowed, bool showEmission,
                          bool isLast, uint32_t width, uint32_t height);

}  // namespace manylight
