#include "apps/view_model/frame_budget.h"
#include "apps/view_model/time_history.h"

#include <gtest/gtest.h>

namespace manylight {
namespace {

/// A device that takes `fullCost` milliseconds for everything and `fixed` for nothing.
FrameQuality settle(FrameBudget& budget, double fullCost, double fixed, double limit, bool hasVpls, int frames = 40) {
    for (int i = 0; i < frames; ++i) {
        const FrameQuality quality = budget.quality(hasVpls);
        budget.report(fixed + fullCost * quality.scale * quality.scale * quality.vpls, limit, hasVpls);
    }
    return budget.quality(hasVpls);
}

double costOf(const FrameQuality& quality) { return quality.scale * quality.scale * quality.vpls; }

TEST(FrameBudget, KeepsWithinTheBudgetAndNotFarBelow) {
    for (const double fullCost : {200.0, 600.0, 3000.0, 9000.0}) {
        FrameBudget budget;
        const double milliseconds = fullCost * costOf(settle(budget, fullCost, 0.0, 80.0, true));
        EXPECT_LE(milliseconds, 80.0) << fullCost;
        EXPECT_GE(milliseconds, 80.0 * 0.8 / 4.0) << fullCost << ": a rung is at most a factor of four";
    }
}

TEST(FrameBudget, LeavesNothingOutOnAFastDevice) {
    FrameBudget budget;
    EXPECT_EQ(settle(budget, 20.0, 1.0, 80.0, true), FrameQuality{});
    EXPECT_EQ(settle(budget, 20.0, 1.0, 80.0, false), FrameQuality{});
}

TEST(FrameBudget, GoesToTheBottomAndStaysThereIfNothingHelps) {
    FrameBudget budget;
    settle(budget, 100.0, 500.0, 80.0, true);
    EXPECT_EQ(budget.rung(), FrameBudget::kRungs - 1);
}

TEST(FrameBudget, DoesNotSwingBetweenTwoRungs) {
    for (const double fullCost : {150.0, 333.0, 777.0, 1500.0}) {
        FrameBudget budget;
        const FrameQuality settled = settle(budget, fullCost, 5.0, 80.0, true);
        for (int i = 0; i < 10; ++i) EXPECT_EQ(settle(budget, fullCost, 5.0, 80.0, true, 1), settled) << fullCost;
    }
}

TEST(FrameBudget, OneSlowFrameAfterAChangeIsNotCounted) {
    FrameBudget budget;
    const uint32_t before = budget.rung();
    budget.report(200.0, 80.0, true);  // pipelines were compiled
    EXPECT_EQ(budget.rung(), before);
    budget.report(200.0, 80.0, true);
    EXPECT_GT(budget.rung(), before);
}

TEST(FrameBudget, WithoutVplsOnlyPixelsAreLeftOut) {
    FrameBudget budget;
    const FrameQuality quality = settle(budget, 4000.0, 0.0, 80.0, false);
    EXPECT_EQ(quality.vpls, 1.0);
    EXPECT_LE(4000.0 * costOf(quality), 80.0);
}

TEST(TimeHistory, AddsUpPassesOfOneNameAndKeepsTheLastFrames) {
    TimeHistory times;
    times.add({{"a", 1.0}, {"b", 2.0}, {"a", 3.0}}, 10.0);
    times.add({{"b", 4.0}, {"c", 1.0}}, 30.0);
    times.add({{"a", 2.0}}, 20.0);
    EXPECT_EQ(times.passes(), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_DOUBLE_EQ(times.frames()[0].sum(), 6.0);
    EXPECT_DOUBLE_EQ(times.mean(0), 3.0) << "over the frames that had it";
    EXPECT_DOUBLE_EQ(times.mean(1), 3.0);
    EXPECT_DOUBLE_EQ(times.medianTotal(), 20.0);
    for (size_t i = 0; i < 2 * TimeHistory::kFrames; ++i) times.add({}, 5.0);
    EXPECT_EQ(times.frames().size(), TimeHistory::kFrames);
    EXPECT_DOUBLE_EQ(times.medianTotal(), 5.0);
}

}  // namespace
}  // namespace manylight
