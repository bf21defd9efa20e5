// The GPU times of the last frames, pass by pass.
#pragma once

#include "engine/graph/execute.h"

#include <deque>
#include <string>
#include <vector>

namespace manylight {

class TimeHistory {
  public:
    static constexpr size_t kFrames = 160;

    /// Passes of one name are added up.
    void add(const std::vector<PassTime>& passes, double frameMilliseconds);
    void clear();

    struct Frame {
        std::vector<double> milliseconds;  // by pass(); may be shorter than the list of passes
        double total = 0.0;                // from one frame to the next
        double sum() const;
    };
    const std::vector<std::string>& passes() const { return passes_; }  // in the order of their first appearance
    const std::deque<Frame>& frames() const { return frames_; }
    /// Over the frames kept; 0 without frames.
    double medianTotal() const;
    /// Mean milliseconds of a pass over the frames that had it.
    double mean(size_t pass) const;

  private:
    std::vector<std::string> passes_;
    std::deque<Frame> frames_;
};

}  // namespace manylight
