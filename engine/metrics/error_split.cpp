#include "engine/metrics/error_split.h"

#include "engine/core/check.h"

namespace manylight {
namespace {

/// The pixels where the reference and all runs are finite, with the counts of what was left out.
PixelUse commonUse(std::span<const Image> runs, const Image& reference, const Mask* mask) {
    PixelUse common = pixelUse(runs.front(), reference, mask);
    for (const Image& run : runs.subspan(1)) {
        const PixelUse use = pixelUse(run, reference, mask);
        for (size_t i = 0; i < use.uses.size(); ++i) common.uses[i] = common.uses[i] && use.uses[i];
    }
    common.compared = 0;
    for (const uint8_t uses : common.uses) common.compared += uses;
    common.nonFinite = common.uses.size() - common.maskedOut - common.compared;
    return common;
}

}  // namespace

ErrorSplit splitError(std::span<const Image> runs, const Image& reference, const Mask* mask) {
    MANYLIGHT_CHECK(runs.size() >= 2u, "a variance needs two runs");
    const PixelUse use = commonUse(runs, reference, mask);
    if (use.compared == 0)
        fail("no pixel left to compare: of {}, {} are masked out and {} not finite", use.uses.size(), use.maskedOut,
             use.nonFinite);

    const auto runCount = static_cast<double>(runs.size());
    double squaredErrorSum = 0.0;
    double varianceSum = 0.0;
    for (size_t texel = 0; texel < reference.texels.size(); ++texel) {
        if (!use.uses[texel / reference.channels]) continue;
        const double expected = reference.texels[texel];
        // Errors, not values, are summed: they are smaller, and the variance is the same.
        double sum = 0.0;
        for (const Image& run : runs) sum += double{run.texels[texel]} - expected;
        const double mean = sum / runCount;
        double squares = 0.0;
        for (const Image& run : runs) {
            const double scatter = double{run.texels[texel]} - expected - mean;
            squares += scatter * scatter;
        }
        varianceSum += squares / (runCount - 1.0);
        squaredErrorSum += mean * mean + squares / runCount;
    }

    const auto count = static_cast<double>(use.compared * reference.channels);
    ErrorSplit split;
    split.meanSquaredError = squaredErrorSum / count;
    split.variance = varianceSum / count;
    split.biasSquared = split.meanSquaredError - split.variance;
    split.pixels = use.compared;
    split.nonFinite = use.nonFinite;
    split.maskedOut = use.maskedOut;
    return split;
}

}  // namespace manylight
