// How much to leave out while something moves, so that a frame takes as long as it may.
#pragma once

#include <cstdint>

namespace manylight {

/// Shares of what was asked for.
struct FrameQuality {
    double scale = 1.0;  // of width and height
    double vpls = 1.0;   // of the number of VPLs, light paths and samples of lights

    bool operator==(const FrameQuality&) const = default;
};

/// Steps down a ladder on which each rung costs about half of the one above, and up again. Few rungs, so that pictures
/// change their size rarely.
class FrameBudget {
  public:
    static constexpr uint32_t kRungs = 11;

    /// `hasVpls`: fewer VPLs make a frame cheaper; otherwise only fewer pixels do.
    FrameQuality quality(bool hasVpls) const;
    /// A frame on the present rung took this long; `budget` is what it may take. Both in milliseconds.
    void report(double milliseconds, double budget, bool hasVpls);
    uint32_t rung() const { return rung_; }

  private:
    uint32_t rung_ = 4;    // where nothing is known yet
    bool isFirst_ = true;  // on this rung: pipelines may have been compiled and memory allocated
};

}  // namespace manylight
