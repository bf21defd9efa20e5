// What the samples of `manylight-bench fps` say: medians, ratios and fits. The tables and files only print it.
#pragma once

#include "apps/bench/fps_measure.h"
#include "engine/core/statistics.h"

namespace manylight {

struct PassSummary {
    std::string pass;
    double milliseconds = 0.0;  // median over the frames
};

struct CellSummary {
    FpsCell cell;
    size_t frameCount = 0;
    Spread wall;              // ms, submit to fence
    double fps = 0.0;         // 1000 / wall.median
    double host = 0.0;        // ms, median
    double gpu = 0.0;         // ms, median
    double vplsShaded = 0.0;  // median
    std::vector<PassSummary> passes;
    std::optional<double> forwardOver;       // wall.median of forward with as many VPLs and the same shadows, over this
    std::optional<double> overDeferred;      // wall.median / that of deferred with as many VPLs and the same shadows
    std::optional<double> seedOverDeferred;  // the same in the seed paper: forward, its VPL counts, no shadows
};

/// Least squares over the medians of one method.
struct FitSummary {
    FpsMethod method = FpsMethod::Deferred;
    bool castShadows = false;
    double fixedMilliseconds = 0.0;
    double millisecondsPerVpl = 0.0;
    double nanosecondsPerPixelAndVpl = 0.0;
    std::optional<Line> seed;  // ms over VPLs, fitted in the same way
};

struct FpsSummary {
    std::vector<CellSummary> cells;
    std::vector<FitSummary> fits;  // of the methods and shadow modes with two VPL counts or more
};

FpsSummary summarise(const FpsRun& run);

}  // namespace manylight
