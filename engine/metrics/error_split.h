// The mean squared error of an estimator, split into what averaging removes and what it does not.
#pragma once

#include "engine/metrics/pixel_use.h"

#include <span>

namespace manylight {

/// Of one run, averaged over pixels and channels: meanSquaredError = biasSquared + variance, exactly.
struct ErrorSplit {
    double meanSquaredError = 0.0;
    /// |mean of the runs - reference|² less what its own noise adds, variance / K: unbiased, so chance makes it
    /// negative where there is no bias.
    double biasSquared = 0.0;
    double variance = 0.0;   // from the runs' scatter, with K - 1
    uint64_t pixels = 0;     // compared
    uint64_t nonFinite = 0;  // left out: not finite in the reference or in any run
    uint64_t maskedOut = 0;
};

/// `runs`: two or more pictures by independent seeds, of the reference's size and channels. Throws Error if no pixel
/// is left to compare.
ErrorSplit splitError(std::span<const Image> runs, const Image& reference, const Mask* mask = nullptr);

}  // namespace manylight
