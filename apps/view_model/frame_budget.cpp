#include "apps/view_model/frame_budget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace manylight {
namespace {

constexpr std::array<FrameQuality, FrameBudget::kRungs> kLadder = {{{1.0, 1.0},
                                                                    {1.0, 0.5},
                                                                    {0.75, 0.5},
                                                                    {0.75, 0.25},
                                                                    {0.5, 0.25},
                                                                    {0.5, 0.125},
                                                                    {0.375, 0.125},
                                                                    {0.375, 0.0625},
                                                                    {0.25, 0.0625},
                                                                    {0.25, 0.03125},
                                                                    {0.125, 0.03125}}};
constexpr double kHeadroom = 0.8;  // of the budget, before a step up: or it would be taken back at once

double costOf(const FrameQuality& quality) { return quality.scale * quality.scale * quality.vpls; }

}  // namespace

FrameQuality FrameBudget::quality(bool hasVpls) const {
    FrameQuality quality = kLadder[rung_];
    if (hasVpls) return quality;
    // The same cost from pixels alone, down to an eighth of the size.
    quality.scale = std::max(std::round(8.0 * std::sqrt(costOf(quality))) / 8.0, 0.125);
    quality.vpls = 1.0;
    return quality;
}

void FrameBudget::report(double milliseconds, double budget, bool hasVpls) {
    if (std::exchange(isFirst_, false) && milliseconds <= 4.0 * budget) return;
    const auto expected = [&](uint32_t rung) {
        FrameBudget other = *this;
        other.rung_ = rung;
        return milliseconds * costOf(other.quality(hasVpls)) / costOf(quality(hasVpls));
    };
    const uint32_t before = rung_;
    uint32_t wanted = rung_;
    if (milliseconds > budget) {
        while (wanted + 1 < kRungs && expected(wanted) > budget) ++wanted;
    } else {
        while (wanted > 0 && expected(wanted - 1) < kHeadroom * budget) --wanted;
    }
    rung_ = wanted;
    isFirst_ = rung_ != before;
}

}  // namespace manylight
