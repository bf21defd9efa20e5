// Frames per second of the view over VPL counts, forward against deferred: measured a frame at a time, so that the
// window goes on.
#pragma once

#include "apps/common/fps_samples.h"

namespace manylight {

class FpsRows {
  public:
    /// Forgets the rows so far. Of `settings` count size, shadows and what all techniques know. `vplCounts`: empty for
    /// those of docs/viewer.md.
    void start(const RenderSettings& settings, std::vector<uint32_t> vplCounts, bool isSoftwareDevice);
    void stop() { nextTurn_ = turns_; }
    bool isRunning() const { return nextTurn_ < turns_; }
    double progress() const { return turns_ > 0 ? static_cast<double>(nextTurn_) / static_cast<double>(turns_) : 0.0; }
    /// One frame of the combination whose turn it is; restarts the renderer where that is another. Throws Error.
    void step(Renderer& renderer);

    /// By VPL count, then forward, with pre-pass, deferred; without samples until its turn has come.
    const std::vector<FpsSamples>& cells() const { return cells_; }
    const RenderSettings& settings() const { return settings_; }

  private:
    RenderSettings settings_;
    std::vector<FpsSamples> cells_;
    size_t turns_ = 0;  // of a cell in a round
    size_t nextTurn_ = 0;
    bool isFresh_ = true;  // the turn has not begun
    uint32_t warmUpsLeft_ = 0;
    uint32_t framesLeft_ = 0;
};

/// One object a measured combination.
Json toJson(const FpsRows& rows);

}  // namespace manylight
