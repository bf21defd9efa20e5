#include "engine/techniques/gather_tuner.h"

namespace manylight {

uint32_t GatherTuner::pixelsPerInvocation() const { return isDone() ? best_ : kCandidates[runs_ % kCandidates.size()]; }

void GatherTuner::report(double milliseconds) {
    if (isDone()) return;
    const bool counts = runs_ >= kCandidates.size();
    const bool isFirst = runs_ == kCandidates.size();
    if (counts && (isFirst || milliseconds < bestMilliseconds_)) {
        best_ = kCandidates[runs_ % kCandidates.size()];
        bestMilliseconds_ = milliseconds;
    }
    ++runs_;
}

}  // namespace manylight
