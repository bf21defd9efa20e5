// From pictures to numbers: errors with error bars, slopes, comparisons at equal time and at equal error.
#pragma once

#include "apps/bench/error_measure.h"
#include "engine/core/statistics.h"

namespace manylight {

/// Estimates are over seeds.
struct ErrorRow {
    uint32_t frames = 0;
    double seconds = 0.0;  // median over seeds
    Estimate rmse;
    double medianRmse = 0.0;    // over seeds: the typical one, also where RMSE has no variance
    Estimate rmseWithoutWorst;  // without the worst 0.1 % of the pixels
    std::optional<Estimate> relativeMse;
    std::optional<Estimate> flip;
    double biasSquared = 0.0;  // of one run; chance makes it negative where there is no bias
    double variance = 0.0;
    uint64_t nonFinite = 0;     // pixels that were left out, over all seeds
    bool isMeasurable = false;  // at least three times the reference's own error
};

struct ModeSummary {
    std::string name;
    std::vector<ErrorRow> rows;
    double frameMilliseconds = 0.0;  // median
    double warmUpSeconds = 0.0;
    std::optional<Estimate> slope;  // of log RMSE over log time, over the measurable rows; three of them at least
    std::optional<Estimate> slopeWithoutWorst;
    std::optional<Estimate> slopeOverFrames;  // the same over log frames: what a busy machine cannot bend
    std::optional<double> slopeOfMedians;     // of log median RMSE over log frames
    Estimate missing;                         // mean radiance of the reference less that of the last row
    std::optional<Estimate> cutOff;
};

/// Errors of all modes at one time, or times to one error, interpolated between rows on logarithmic scales; empty
/// outside of what was measured.
struct Comparison {
    double at = 0.0;  // seconds, or RMSE
    std::vector<std::optional<double>> values;
};

struct ErrorSummary {
    double referenceError = 0.0;  // its own RMSE over the compared pixels; 0 if it is not known
    std::vector<ModeSummary> modes;
    std::vector<Comparison> equalTime;
    std::vector<Comparison> equalError;
};

ErrorSummary summarise(const ErrorRun& run, const ErrorOptions& options);

}  // namespace manylight
