#include "apps/capture/frame_loop.h"

#include "apps/common/interrupt.h"
#include "engine/core/progress.h"

#include <algorithm>
#include <chrono>
#include <map>

namespace manylight {
namespace {

using Clock = std::chrono::steady_clock;

/// The error is looked at after ever more frames, as reading pictures back takes time too.
class ErrorCheck {
  public:
    explicit ErrorCheck(double target) : target_(target) {}
    bool isMet(Renderer& renderer, Frames& frames) {
        if (target_ <= 0.0 || renderer.frameCount() < next_) return false;
        next_ = renderer.frameCount() + renderer.frameCount() / 8 + 1;
        frames.relativeError = renderer.relativeStandardError();
        return *frames.relativeError <= target_;
    }

  private:
    static constexpr uint32_t kFewestFrames = 8;  // fewer say too little about their own scatter
    double target_;
    uint32_t next_ = kFewestFrames;
};

/// Progress by frames or by time, whichever is nearer its end.
class LoopProgress {
  public:
    explicit LoopProgress(const CaptureOptions& options)
        : options_(options), progress_("rendering", kSteps, options.showsProgress) {}
    void update(uint32_t frames, double seconds) {
        double share = static_cast<double>(frames) / options_.mostFrames();
        if (options_.secondsBudget > 0.0) share = std::max(share, seconds / options_.secondsBudget);
        const auto steps = static_cast<uint64_t>(std::min(share, 1.0) * static_cast<double>(kSteps));
        if (steps > done_) progress_.advance(steps - done_);
        done_ = std::max(done_, steps);
    }

  private:
    static constexpr uint64_t kSteps = 1000;
    const CaptureOptions& options_;
    Progress progress_;
    uint64_t done_ = 0;
};

}  // namespace

Frames renderFrames(Renderer& renderer, const CaptureOptions& options) {
    const InterruptGuard guard;
    LoopProgress progress(options);
    ErrorCheck error(options.targetError);
    Frames frames;
    std::map<std::string, double> passTimes;
    const auto start = Clock::now();
    for (uint32_t i = 0; i < options.mostFrames(); ++i) {
        Execution execution = renderer.renderFrame();
        for (const PassTime& pass : execution.passTimes) passTimes[pass.pass] += pass.milliseconds;
        frames.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (i == 0) frames.firstFrameSeconds = frames.seconds;
        frames.dumped = std::move(execution.dumped);
        progress.update(i + 1, frames.seconds);
        if (error.isMet(renderer, frames)) frames.endedBy = "error";
        if (options.secondsBudget > 0.0 && frames.seconds >= options.secondsBudget) frames.endedBy = "time";
        if (isInterrupted()) frames.endedBy = "interrupt";
        if (frames.endedBy != std::string("frames")) break;
    }
    for (const auto& [pass, milliseconds] : passTimes) frames.passes[pass] = milliseconds;
    return frames;
}

}  // namespace manylight
