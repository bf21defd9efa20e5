// The part that deferred and forward share: light paths to VPLs, and how many real lights there are.
#pragma once

#include "engine/passes/vpl_buffers.h"
#include "engine/techniques/frame_inputs.h"

#include <optional>

namespace manylight {

struct LightsOfFrame {
    uint32_t lightCount = 0;  // at a point: real lights and samples of area lights; 0 if direct light is not asked for
    VplBuffers vpls;
    uint32_t vplCount = 0;  // 0 if indirect light is not asked for, or there are no light paths

    /// The VPL list, if there is more in it than darkness.
    std::optional<BufferHandle> list() const { return vplCount > 0 ? std::optional(vpls.list) : std::nullopt; }
};

LightsOfFrame addLightsOfFrame(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs);

}  // namespace manylight
