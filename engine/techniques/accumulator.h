// A picture's mean over frames, and how far frames scatter about it.
#pragma once

#include "engine/image/image.h"
#include "engine/passes/accumulate.h"

#include <optional>
#include <string>

namespace manylight {

/// RGB of an RGBA32F image, times `scale`.
Image scaledRgb(gpu::Device& device, PhysicalImage& source, double scale);

class Accumulator {
  public:
    Accumulator() = default;
    Accumulator(gpu::Device& device, const std::string& name, uint32_t width, uint32_t height, bool keepsVariance);
    bool exists() const { return sum_.texture.exists(); }
    bool keepsVariance() const { return squaredDeviations_.texture.exists(); }

    /// Declares that `radiance` is added after `frameCount` frames. Returns the sum.
    ImageHandle add(FrameGraph& graph, const SceneHandles& scene, ImageHandle radiance, uint32_t frameCount);

    /// The sum so far, to be read.
    ImageHandle sum(FrameGraph& graph) { return importPhysical(graph, name_ + " sum", sum_); }
    /// RGB; `frameCount` frames, at least 1.
    Image mean(gpu::Device& device, uint32_t frameCount);
    /// Variance of mean(), RGB, if frames are independent; at least 2 frames.
    Image varianceOfMean(gpu::Device& device, uint32_t frameCount);

  private:
    PhysicalImage sum_;
    PhysicalImage roundingError_;
    PhysicalImage squaredDeviations_;  // only if the variance is asked for
    std::string name_;
    uint32_t width_ = 0;
    uint32_t height_ = 0;
};

}  // namespace manylight
