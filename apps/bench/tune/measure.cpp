#include "apps/bench/tune/measure.h"

#include "apps/bench/calibration.h"
#include "apps/bench/tune/scenes.h"
#include "apps/bench/tune/workloads.h"
#include "apps/common/command_line.h"
#include "apps/common/interrupt.h"
#include "engine/core/error.h"
#include "engine/core/progress.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

namespace manylight {
namespace {

bool sameBytes(const Image& a, const Image& b) {
    return a.texels.size() == b.texels.size() &&
           std::memcmp(a.texels.data(), b.texels.data(), a.texels.size() * sizeof(float)) == 0;
}

void checkTunables(const TuneOptions& options) {
    std::string names;
    for (const gpu::Tunable& tunable : gpu::tunables())
        names += (names.empty() ? "" : ", ") + std::string(tunable.name);
    for (const std::string& name : options.tunables)
        if (std::ranges::none_of(gpu::tunables(), [&](const gpu::Tunable& known) { return name == known.name; }))
            failUsage("--tunables '{}': expected one of {}", name, names);
}

/// What `reach` takes in a frame of each workload that it names.
struct Timing {
    std::vector<double> milliseconds;
    double sum() const {
        double result = 0.0;
        for (const double time : milliseconds) result += time;
        return result;
    }
    /// Geometric mean of the ratios to `other`, so that a short workload counts as much as a long one.
    double ratioTo(const Timing& other) const {
        double logarithms = 0.0;
        double count = 0.0;
        for (size_t i = 0; i < milliseconds.size(); ++i) {
            if (milliseconds[i] <= 0.0 || other.milliseconds[i] <= 0.0) continue;  // a pass that is not there
            logarithms += std::log(milliseconds[i] / other.milliseconds[i]);
            count += 1.0;
        }
        return count > 0.0 ? std::exp(logarithms / count) : 1.0;
    }
};

class Tuner {
  public:
    Tuner(Workloads& workloads, const gpu::GroupLimits& limits, uint32_t turns)
        : workloads_(workloads), limits_(limits), turns_(turns) {}

    /// Empty if it was interrupted.
    std::optional<TunedValue> measure(const gpu::Tunable& tunable, const gpu::Tuning& base) {
        const Reach reach = reachOf(tunable.name);
        TunedValue result;
        result.tunable = tunable.name;
        result.what = tunable.what;
        std::vector<gpu::Tuning> tunings;
        for (const uint32_t value : tunable.values) {
            gpu::Tuning tuning = base;
            tunable.of(tuning) = value;
            if (!gpu::fits(tuning, limits_)) continue;
            tunings.push_back(tuning);
            result.candidates.emplace_back().value = value;
        }
        Progress progress("tune " + result.tunable, tunings.size() * (turns_ + 1));
        if (!comparePictures(reach, tunings, result.candidates, progress)) return std::nullopt;
        for (uint32_t turn = 0; turn < turns_; ++turn) {
            std::vector<Timing> timings(tunings.size());
            for (size_t i = 0; i < tunings.size(); ++i) {
                const size_t candidate = (i + turn) % tunings.size();  // none is always the first
                timings[candidate] = timingOf(reach, tunings[candidate]);
                if (isInterrupted()) return std::nullopt;
                progress.advance();
            }
            for (size_t i = 0; i < tunings.size(); ++i) {
                result.candidates[i].milliseconds.push_back(timings[i].sum());
                result.candidates[i].ratios.push_back(timings[i].ratioTo(timings[0]));
            }
        }
        result.chosen = chosenOf(result.candidates);
        return result;
    }

    /// Ratios of whole frames with `tuning` to those with the default.
    std::vector<double> compareFrames(const gpu::Tuning& tuning) {
        const Reach all{{Way::Gather, Way::Shadows, Way::Draft, Way::Paths}, {""}};
        Progress progress("tune: all together", turns_);
        std::vector<double> ratios;
        for (uint32_t turn = 0; turn < turns_ && !isInterrupted(); ++turn) {
            const Timing before = timingOf(all, turn % 2 == 0 ? gpu::Tuning{} : tuning);
            const Timing after = timingOf(all, turn % 2 == 0 ? tuning : gpu::Tuning{});
            ratios.push_back(turn % 2 == 0 ? after.ratioTo(before) : before.ratioTo(after));
            progress.advance();
        }
        return ratios;
    }

  private:
    /// The first frame with each, which may compile. False if it was interrupted.
    bool comparePictures(const Reach& reach, const std::vector<gpu::Tuning>& tunings,
                         std::vector<TuneCandidate>& candidates, Progress& progress) {
        std::vector<Image> pictures;
        for (size_t i = 0; i < tunings.size(); ++i) {
            size_t picture = 0;
            for (Workload& workload : workloads_) {
                if (!isReached(reach, workload)) continue;
                renderWith(workload, tunings[i]);
                const Image image = workload.renderer->radiance();
                if (i == 0)
                    pictures.push_back(image);
                else
                    candidates[i].sameBytes = candidates[i].sameBytes && sameBytes(image, pictures[picture++]);
                if (isInterrupted()) return false;
            }
            progress.advance();
        }
        return true;
    }

    Timing timingOf(const Reach& reach, const gpu::Tuning& tuning) {
        Timing timing;
        for (Workload& workload : workloads_) {
            if (isInterrupted()) return timing;
            if (isReached(reach, workload))
                timing.milliseconds.push_back(milliseconds(renderWith(workload, tuning), reach));
        }
        return timing;
    }

    static bool isReached(const Reach& reach, const Workload& workload) {
        return std::ranges::find(reach.ways, workload.way) != reach.ways.end();
    }

    Workloads& workloads_;
    gpu::GroupLimits limits_;
    uint32_t turns_;
};

}  // namespace

size_t chosenOf(const std::vector<TuneCandidate>& candidates) {
    size_t chosen = 0;
    double best = kGainWorthHaving;
    for (size_t i = 1; i < candidates.size(); ++i) {
        const Spread ratio = spreadOf(candidates[i].ratios);
        if (!candidates[i].sameBytes || ratio.median >= best || ratio.p95 >= 1.0) continue;
        chosen = i;
        best = ratio.median;
    }
    return chosen;
}

TuneRun measureTuning(const TuneOptions& options) {
    checkTunables(options);
    const InterruptGuard guard;
    TuneRun run;
    gpu::Device device({.select = options.device});
    run.machine = describeMachine(device);
    run.key = gpu::tuningKey(device);
    run.calibration.push_back(calibrationMilliseconds());
    const std::vector<Scene> scenes = scenesOf(options);
    for (const Scene& scene : scenes) {
        printWarnings(scene.warnings);
        run.scenes.push_back(scene.name);
    }
    Workloads workloads = makeWorkloads(device, scenes, options);
    Tuner tuner(workloads, gpu::groupLimits(device), options.turns);
    for (const gpu::Tunable& tunable : gpu::tunables()) {
        if (!isAskedFor(options, tunable)) continue;
        if (isInterrupted()) break;
        std::optional<TunedValue> measured = tuner.measure(tunable, run.tuning);
        if (!measured) break;
        tunable.of(run.tuning) = measured->candidates[measured->chosen].value;
        run.values.push_back(std::move(*measured));
    }
    if (run.tuning != gpu::Tuning{}) run.ratios = tuner.compareFrames(run.tuning);
    run.isInterrupted = isInterrupted();
    run.calibration.push_back(calibrationMilliseconds());
    return run;
}

}  // namespace manylight
