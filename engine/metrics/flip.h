// FLIP: how different two pictures look when one flips between them (Andersson2020), for pictures of any range
// (Andersson2021) and for displayed ones. Agrees with the authors' evaluator; docs/measuring-error.md has the rest.
#pragma once

#include "engine/metrics/flip_perception.h"
#include "engine/metrics/pixel_use.h"

#include <optional>

namespace manylight {

/// A screen of 3840 pixels, as wide as it is far away: 67.02.
constexpr double kDefaultPixelsPerDegree = 67.0206432765823;
constexpr double kMinPixelsPerDegree = 1.0;
constexpr double kMaxPixelsPerDegree = 1000.0;

/// Exposures in stops (values are multiplied by 2^stop), evenly spaced from `start` to `stop`.
struct FlipExposures {
    double start = 0.0;
    double stop = 0.0;
    uint32_t count = 1;
    double at(uint32_t i) const { return count < 2 ? start : start + (stop - start) * i / (count - 1); }
};

/// The exposures that HDR-FLIP derives from the reference's brightest and median luminance over the pixels in `uses`
/// (Andersson2021, with the evaluator's floor of 2^-23 for a black median). Empty if no pixel is brighter than zero.
std::optional<FlipExposures> flipExposures(const Image& reference, const std::vector<uint8_t>& uses);

struct FlipOptions {
    double pixelsPerDegree = kDefaultPixelsPerDegree;
    const Mask* mask = nullptr;
};

struct FlipResult {
    double mean = 0.0;        // over the compared pixels
    Image map;                // one channel: error of every pixel, 0 to 1; NaN where a picture is not finite
    FlipExposures exposures;  // of HDR-FLIP
    uint64_t pixels = 0;      // compared
    uint64_t nonFinite = 0;   // left out of the mean, black in both pictures for their neighbours' sake
};

/// Linear radiance, any range: the largest LDR-FLIP over the reference's exposures, at each pixel. Empty if the
/// reference is black. Throws Error if no pixel is left to compare.
std::optional<FlipResult> hdrFlip(const Image& test, const Image& reference, const FlipOptions& options = {});

/// A reference that many pictures are compared with: its half of the work is done once. Holds 20 bytes for each pixel
/// and exposure; a mask in `options` has to outlive it.
class HdrFlipReference {
  public:
    explicit HdrFlipReference(Image reference, const FlipOptions& options = {});
    /// hdrFlip(test, reference, options), to the bit.
    std::optional<FlipResult> compare(const Image& test) const;

  private:
    Image reference_;
    FlipOptions options_;
    FlipFilters filters_;
    std::vector<uint8_t> isFinite_;
    std::optional<FlipExposures> exposures_;
    std::vector<Perceived> perceived_;  // at each exposure
};

/// Display-linear values (decoded sRGB), clamped to [0, 1]. Throws Error if no pixel is left to compare.
FlipResult ldrFlip(const Image& test, const Image& reference, const FlipOptions& options = {});

}  // namespace manylight
