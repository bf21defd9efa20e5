// A number that is measured every frame, over the last frames.
#pragma once

#include "engine/core/statistics.h"

#include <deque>
#include <vector>

namespace manylight {

class RecentValues {
  public:
    static constexpr size_t kMost = 160;

    void add(double value) {
        values_.push_back(value);
        if (values_.size() > kMost) values_.pop_front();
    }
    bool empty() const { return values_.empty(); }
    /// 0 without values.
    double middle() const { return empty() ? 0.0 : median({values_.begin(), values_.end()}); }

  private:
    std::deque<double> values_;
};

}  // namespace manylight
