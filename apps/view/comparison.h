// How far one side is from the other, as numbers and in false colours.
#pragma once

#include "apps/view/side.h"
#include "engine/metrics/error.h"

namespace manylight {

class Comparison {
  public:
    explicit Comparison(gpu::Device& device) : device_(device) {}

    /// Compares mean radiances. The reference is the other side's picture, or a file's. Throws Error if they differ in
    /// size. Nothing that presents picture() may run.
    void update(Renderer& side, const Image& reference);
    /// Forgets what was compared.
    void clear() { report_.reset(); }
    const std::optional<ErrorReport>& report() const { return report_; }
    /// Blue: the main side is darker; red: brighter; strongest at `kFullColour` times the mean luminance.
    PhysicalImage& picture() { return picture_; }
    static constexpr double kFullColour = 0.5;

  private:
    void paint(const Image& test, const Image& reference, double meanLuminance);

    gpu::Device& device_;
    std::optional<ErrorReport> report_;
    PhysicalImage picture_;
};

}  // namespace manylight
