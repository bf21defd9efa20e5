// The measurement of `manylight-bench fps`: frame times of every combination, in interleaved rounds.
#pragma once

#include "apps/bench/fps_options.h"
#include "apps/common/fps_samples.h"

namespace manylight {

/// What is paid once, in seconds.
struct OneOffTimes {
    double importing = 0.0;
    double bvhBuild = 0.0;
    double upload = 0.0;
    double firstFrame = 0.0;  // of the first cell, with the compilation of its pipelines
};

struct FpsRun {
    std::string sceneName;
    size_t triangleCount = 0;
    RenderSettings settings;  // resolved; technique, castShadows and vplCount are the cells'
    Json machine;
    bool softwareDevice = false;
    OneOffTimes oneOff;
    std::vector<uint32_t> shadowedVplCounts;
    std::vector<FpsSamples> cells;    // by shadows, then VPL count, then technique
    std::vector<double> calibration;  // milliseconds: before every round, and after the last
    bool isInterrupted = false;       // some combinations have fewer frames than asked for, or are missing
    Warnings warnings;
};

/// Imports the scene and measures. Throws Error.
FpsRun measureFps(const FpsOptions& options);

}  // namespace manylight
