// How far one side is from the other, as numbers and in false colours.
#pragma once

#include "apps/view/side.h"
#include "engine/metrics/error.h"

#include <chrono>

namespace manylight {

class Comparison {
  public:
    explicit Comparison(gpu::Device& device) : device_(device) {}

    /// Compares mean radiances; `isLast`: no further frames will come. The reference is the other side's picture, or a
    /// file's. Throws Error if they differ in size. Nothing that presents picture() may run.
    void update(Renderer& side, const Image& reference, bool isLast);
    /// Forgets what was compared.
    void clear();
    const std::optional<ErrorReport>& report() const { return report_; }
    /// FLIP, HDR: computed now and then, as it takes long. Empty until then, and for a black reference.
    const std::optional<double>& flip() const { return flip_; }
    /// Blue: the main side is darker; red: brighter; strongest at `kFullColour` times the mean luminance.
    PhysicalImage& picture() { return picture_; }
    static constexpr double kFullColour = 0.5;

  private:
    void paint(const Image& test, const Image& reference, double meanLuminance);
    void measureFlip(const Image& test, const Image& reference);

    gpu::Device& device_;
    std::optional<ErrorReport> report_;
    std::optional<double> flip_;
    std::chrono::steady_clock::time_point flipAt_;
    double flipSeconds_ = 0.0;  // that it took last time
    PhysicalImage picture_;
};

}  // namespace manylight
