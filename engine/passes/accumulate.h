// The running sum of frames, in images that outlive them.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

/// RGBA32F each. The sum is exact to its last bit however many frames there are; `roundingError` is what that takes.
struct RunningSum {
    ImageHandle sum;
    ImageHandle roundingError;
};

/// Adds `radiance`, or starts with the first frame. Returns the new versions.
RunningSum addAccumulate(FrameGraph& graph, const SceneHandles& scene, ImageHandle radiance, RunningSum running,
                         bool isFirstFrame, uint32_t width, uint32_t height);

/// Adds the frame's squared deviation from the mean so far; `sum` is the sum without the frame. The variance of one
/// frame is the result / (frames - 1). Begins with the second frame. Returns the new version of `squaredDeviations`.
ImageHandle addVariance(FrameGraph& graph, const SceneHandles& scene, ImageHandle radiance, ImageHandle sum,
                        ImageHandle squaredDeviations, bool isSecondFrame, uint32_t width, uint32_t height);

}  // namespace manylight
