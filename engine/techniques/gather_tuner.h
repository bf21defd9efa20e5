// Which variant of the gather is fastest on this device: tried out on real frames, as all give the same picture.
#pragma once

#include <array>
#include <cstdint>

namespace manylight {

/// Explore, then commit. Each candidate runs twice; its first run, which may compile, does not count.
class GatherTuner {
  public:
    /// Pixels per invocation for the next frame.
    uint32_t pixelsPerInvocation() const;
    /// Milliseconds the gather took in the frame that used pixelsPerInvocation().
    void report(double milliseconds);
    bool isDone() const { return runs_ == 2 * kCandidates.size(); }

  private:
    static constexpr std::array<uint32_t, 3> kCandidates = {4, 8, 2};

    uint32_t runs_ = 0;  // candidate runs_ % 3 is next
    uint32_t best_ = kCandidates[0];
    double bestMilliseconds_ = 0.0;
};

}  // namespace manylight
