#include "apps/view_model/time_history.h"

#include <algorithm>
#include <numeric>

namespace manylight {

double TimeHistory::Frame::sum() const { return std::accumulate(milliseconds.begin(), milliseconds.end(), 0.0); }

void TimeHistory::add(const std::vector<PassTime>& passes, double frameMilliseconds) {
    Frame frame;
    frame.total = frameMilliseconds;
    frame.milliseconds.resize(passes_.size());
    for (const PassTime& pass : passes) {
        const auto found = std::find(passes_.begin(), passes_.end(), pass.pass);
        const auto index = static_cast<size_t>(found - passes_.begin());
        if (found == passes_.end()) {
            passes_.push_back(pass.pass);
            frame.milliseconds.push_back(0.0);
        }
        frame.milliseconds[index] += pass.milliseconds;
    }
    frames_.push_back(std::move(frame));
    if (frames_.size() > kFrames) frames_.pop_front();
}

void TimeHistory::clear() {
    passes_.clear();
    frames_.clear();
}

double TimeHistory::medianTotal() const {
    if (frames_.empty()) return 0.0;
    std::vector<double> totals;
    for (const Frame& frame : frames_) totals.push_back(frame.total);
    const auto middle = totals.begin() + static_cast<ptrdiff_t>(totals.size() / 2);
    std::nth_element(totals.begin(), middle, totals.end());
    return *middle;
}

double TimeHistory::mean(size_t pass) const {
    double sum = 0.0;
    size_t count = 0;
    for (const Frame& frame : frames_) {
        if (pass >= frame.milliseconds.size() || frame.milliseconds[pass] == 0.0) continue;
        sum += frame.milliseconds[pass];
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace manylight
