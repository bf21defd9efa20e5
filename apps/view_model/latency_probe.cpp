#include "apps/view_model/latency_probe.h"

#include "engine/core/statistics.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

constexpr double kGoldenRatio = 0.6180339887498949;  // its multiples are spread evenly over [0, 1)

double fraction(double x) { return x - std::floor(x); }

template <typename Member>
std::vector<double> valuesOf(const std::vector<LatencyProbe::Sample>& samples, Member member) {
    std::vector<double> values;
    for (const LatencyProbe::Sample& sample : samples) values.push_back(sample.*member);
    return values;
}

}  // namespace

void LatencyProbe::start(uint32_t sampleCount) {
    *this = {};
    left_ = sampleCount;
}

bool LatencyProbe::takeInput(double now) {
    if (!isRunning() || isTaken_ || inputAt_ < 0.0 || now < inputAt_) return false;
    isTaken_ = true;
    return true;
}

void LatencyProbe::presented(double now, bool showsInput) {
    if (!isRunning()) return;
    const double frame = lastPresented_ >= 0.0 ? now - lastPresented_ : -1.0;
    lastPresented_ = now;
    if (inputAt_ >= 0.0 && now < inputAt_) windowStart_ = now;
    if (inputAt_ >= 0.0 && now >= inputAt_) ++framesSinceInput_;
    if (isTaken_ && showsInput) {
        const double latency = now - inputAt_;
        samples_.push_back({latency, latency * framesSinceInput_ / (now - windowStart_)});
        --left_;
        isTaken_ = false;
        inputAt_ = -1.0;
    }
    if (inputAt_ >= 0.0 || frame < 0.0) return;
    // The next input comes somewhere in the frame that begins now, if that takes as long as the last one.
    windowStart_ = now;
    inputAt_ = now + fraction(kGoldenRatio * static_cast<double>(samples_.size() + 1)) * frame;
    framesSinceInput_ = 0;
}

double LatencyProbe::medianFrames() const {
    return samples_.empty() ? 0.0 : median(valuesOf(samples_, &Sample::frames));
}

double LatencyProbe::mostFrames() const {
    double most = 0.0;
    for (const Sample& sample : samples_) most = std::max(most, sample.frames);
    return most;
}

double LatencyProbe::medianSeconds() const {
    return samples_.empty() ? 0.0 : median(valuesOf(samples_, &Sample::seconds));
}

}  // namespace manylight
