// The last step of the reconstruction: from filtered light to radiance.
#pragma once

#include "engine/passes/gbuffer.h"

#include <optional>

namespace manylight {

/// Multiplies `light` by what the receivers reflect of it and adds it to `radiance`, or to nothing; returns the new
/// version. All RGBA32F.
ImageHandle addRemodulate(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan, const GBuffer& gbuffer,
                          ImageHandle light, std::optional<ImageHandle> radiance, uint32_t width, uint32_t height);

}  // namespace manylight
