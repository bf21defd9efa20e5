// One path from the camera through every pixel.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

struct PathTraceOptions {
    uint32_t minScatterings = 0;  // 0: emission that the camera sees; 1: direct light; 2: one bounce
    uint32_t maxScatterings = 0;
    bool russianRoulette = true;
    bool jitter = false;
};

/// Returns the frame's radiance, RGBA32F: light that was scattered minScatterings to maxScatterings times.
ImageHandle addPathTrace(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, const PathTraceOptions& options,
                         uint32_t width, uint32_t height);

}  // namespace manylight
