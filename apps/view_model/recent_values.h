// A number that is measured every frame, over the last frames.
#pragma once

#include <algorithm>
#include <deque>
#include <numeric>

namespace manylight {

class RecentValues {
  public:
    static constexpr size_t kMost = 160;

    void add(double value) {
        values_.push_back(value);
        if (values_.size() > kMost) values_.pop_front();
    }
    bool empty() const { return values_.empty(); }
    /// 0 without values, as the least is.
    double mean() const {
        return empty() ? 0.0
                       : std::accumulate(values_.begin(), values_.end(), 0.0) / static_cast<double>(values_.size());
    }
    double least() const { return empty() ? 0.0 : *std::min_element(values_.begin(), values_.end()); }

  private:
    std::deque<double> values_;
};

}  // namespace manylight
