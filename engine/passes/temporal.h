// Temporal accumulation: light of earlier views, found again from where the camera is now, stands in for frames to
// come.
#pragma once

#include "engine/passes/gbuffer.h"
#include "shaders/shared/temporal.h"

namespace manylight {

/// What one view leaves to the next, in images that outlive frames.
struct TemporalImages {
    ImageHandle shown;  // RGBA32F: sum over frames with the history in it; how many frames that is worth
    ImageHandle guide;  // RGBA32_UINT, of the same size: see shaders/lib/history.glsl
};

/// In the first frame of a view: writes to `history` (RGBA32_UINT) what the view before it, described by `push`, showed
/// of the same points; nothing where it did not see them. `radiance` is this frame's. Returns the new version.
ImageHandle addReprojection(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                            ImageHandle radiance, const TemporalImages& before, ImageHandle history,
                            const shared::ReprojectionPush& push, uint32_t width, uint32_t height);

/// Writes the picture that is shown after `frameCount` frames of a view, of which `sum` is the sum and `radiance` the
/// last. `history` is cleared unless `hasHistory`. Returns the new versions.
TemporalImages addTemporal(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                           ImageHandle radiance, ImageHandle sum, ImageHandle history, bool hasHistory,
                           TemporalImages images, uint32_t frameCount, uint32_t width, uint32_t height);

}  // namespace manylight
