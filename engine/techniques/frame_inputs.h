// What a technique is given to declare one frame.
#pragma once

#include "engine/passes/gbuffer.h"
#include "engine/techniques/settings.h"

#include <algorithm>
#include <vector>

namespace manylight {

/// A point of all pixels at which a frame asks what is seen.
struct SeenPoint {
    BufferHandle frameConstants;
    glm::vec2 offset{0.5f};  // in the pixel
};

struct FrameInputs {
    const RenderSettings& settings;  // resolved: sizes, counts and bounces are final
    const ScenePlan& plan;
    const GpuScene& gpuScene;
    uint32_t frame = 0;  // frames before this one
    uint32_t subgroupSize = 32;
    uint32_t pixelsPerInvocation = 4;    // of the gather without shadows
    std::vector<SeenPoint> points = {};  // the first is that of the scene's handles; see visibilitySamples()
    glm::vec3 environmentRadiance{0.0f};
    bool gbufferByRays = false;
    bool keepsCutOff = false;  // TechniqueResult::cutOff is asked for

    uint32_t pointCount() const { return std::max(static_cast<uint32_t>(points.size()), 1u); }
};

/// What a technique leaves: linear radiance, and the depth it saw.
struct TechniqueResult {
    ImageHandle radiance;
    std::optional<ImageHandle> depth = std::nullopt;  // a path tracer has none
    std::optional<BufferHandle> vpls = std::nullopt;
    std::optional<ImageHandle> cutOff =
        std::nullopt;                               // radiance that the bound on the geometry term took; deferred only
    std::optional<GBuffer> gbuffer = std::nullopt;  // deferred only
};

}  // namespace manylight
