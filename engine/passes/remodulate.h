// The last step of the reconstruction: from light to radiance.
#pragma once

#include "engine/passes/gbuffer.h"

#include <glm/vec2.hpp>

#include <optional>

namespace manylight {

/// Light that is known at other points of the pixels.
struct LentLight {
    ImageHandle light;
    ImageHandle guide;  // of addReconstructGuide()
    glm::vec2 offset;   // from the point that borrows, pixels
};

/// Multiplies light by what the receivers in `gbuffer` reflect of it, adds it to `radiance`, or to nothing, and
/// multiplies the sum by `scale`; returns the new version. All RGBA32F. Light is `own` and what is `lent`. `scene`:
/// with frame constants of the G-buffer's point.
ImageHandle addRemodulate(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                          std::optional<ImageHandle> own, const std::optional<LentLight>& lent,
                          std::optional<ImageHandle> radiance, float scale, uint32_t width, uint32_t height);

}  // namespace manylight
