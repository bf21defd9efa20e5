// Forward shading: the fragment shader loops over the real lights and then over the VPLs.
#pragma once

#include "engine/passes/gpu_scene.h"
#include "engine/passes/visibility.h"
#include "engine/passes/vpl_buffers.h"

#include <optional>
#include <span>

namespace manylight {

struct ForwardOptions {
    uint32_t lightCount = 0;  // as addDirectLight() counts them
    uint32_t vplCount = 0;
    bool castShadows = true;
    bool showEmission = true;
    bool compensates = false;             // for the bound on the geometry term, see compensation.h
    glm::vec3 environmentRadiance{0.0f};  // where no surface is seen
};

struct ForwardResult {
    ImageHandle radiance;  // RGBA32F
    ImageHandle depth;
};

/// `prepass`: only what it saw is shaded; without it the fragments of hidden surfaces that come first are shaded too,
/// as the original system did. More lights than a draw may take on are drawn again, adding, on what is seen.
ForwardResult addForward(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const VplBuffers& vpls,
                         const ForwardOptions& options, std::optional<Visibility> prepass,
                         std::span<const DrawRange> draws, uint32_t width, uint32_t height);

}  // namespace manylight
