// The measurement of `manylight-bench tune`: one tunable after the other, each with what was chosen for those before.
#pragma once

#include "apps/bench/tune/options.h"
#include "engine/core/report.h"
#include "engine/core/statistics.h"
#include "engine/gpu/tuning.h"
#include "engine/gpu/tuning_file.h"

namespace manylight {

struct TuneCandidate {
    uint32_t value = 0;
    std::vector<double> milliseconds;  // of a turn, all workloads together
    std::vector<double> ratios;        // to the default's of the same turn: geometric means over workloads
    bool sameBytes = true;             // as the default's pictures
};

struct TunedValue {
    std::string tunable;
    std::string what;
    std::vector<TuneCandidate> candidates;  // the default first
    size_t chosen = 0;
};

struct TuneRun {
    Json machine;
    gpu::TuningKey key;
    std::vector<std::string> scenes;
    std::vector<TunedValue> values;
    std::vector<double> ratios;  // whole frames with all that was chosen, to those with the default; none: nothing was
    gpu::Tuning tuning;          // what is best: the default unless it is faster beyond the noise
    std::vector<double> calibration;  // milliseconds, before and after
    bool isInterrupted = false;
};

/// Another value is chosen where its median ratio is below this, and its 95th percentile below 1.
inline constexpr double kGainWorthHaving = 0.97;
/// The index of what to choose; 0, the default, unless another is faster beyond the noise.
size_t chosenOf(const std::vector<TuneCandidate>& candidates);

TuneRun measureTuning(const TuneOptions& options);

}  // namespace manylight
