#include "engine/core/check.h"
#include "engine/core/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace manylight {
namespace {

TEST(Statistics, MedianOfOddAndEvenCounts) {
    EXPECT_EQ(median({7.0}), 7.0);
    EXPECT_EQ(median({9.0, 1.0, 5.0}), 5.0);
    EXPECT_EQ(median({4.0, 1.0, 2.0, 100.0}), 3.0);
}

TEST(Statistics, TheErrorOfAMeanIsThatOfItsSamplesByTheRootOfTheirCount) {
    const Estimate found = estimate({2.0, 4.0, 4.0, 6.0});  // variance 8/3
    EXPECT_DOUBLE_EQ(found.mean, 4.0);
    EXPECT_DOUBLE_EQ(found.error, std::sqrt(8.0 / 3.0 / 4.0));
    EXPECT_EQ(estimate({3.0}).error, 0.0);
}

TEST(Statistics, PercentilesAreLinearBetweenNeighbours) {
    const std::vector<double> values = {50.0, 10.0, 40.0, 20.0, 30.0};
    EXPECT_EQ(percentile(values, 0.0), 10.0);
    EXPECT_EQ(percentile(values, 1.0), 50.0);
    EXPECT_EQ(percentile(values, 0.25), 20.0);
    EXPECT_DOUBLE_EQ(percentile(values, 0.05), 12.0);
    EXPECT_DOUBLE_EQ(percentile(values, 0.95), 48.0);
}

TEST(Statistics, SpreadIsMedianAndPercentiles) {
    std::vector<double> values;
    for (int i = 100; i >= 0; --i) values.push_back(i);
    const Spread spread = spreadOf(values);
    EXPECT_DOUBLE_EQ(spread.median, 50.0);
    EXPECT_DOUBLE_EQ(spread.p5, 5.0);
    EXPECT_DOUBLE_EQ(spread.p95, 95.0);
}

TEST(Statistics, TheMedianLiesInItsIntervalAtLeastNineteenTimesOfTwenty) {
    std::vector<double> ranks;
    for (int i = 99; i >= 0; --i) ranks.push_back(i);
    EXPECT_EQ(intervalOfMedian(ranks).low, 39.0);  // the 40th: 50 - 9.8, downwards
    EXPECT_EQ(intervalOfMedian(ranks).high, 60.0);
    EXPECT_EQ(intervalOfMedian({2.0, 1.0}).low, 1.0);
    EXPECT_EQ(intervalOfMedian({2.0, 1.0}).high, 2.0);
    // Skewed samples, whose median is ln 2. Seven or more of 25 lie on either side in 98.54 of 100 trials (binomial).
    std::mt19937 bits(7);
    std::exponential_distribution<double> exponential(1.0);
    int held = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        std::vector<double> samples(25);
        for (double& sample : samples) sample = exponential(bits);
        const Interval interval = intervalOfMedian(samples);
        held += interval.low <= std::log(2.0) && std::log(2.0) <= interval.high ? 1 : 0;
    }
    EXPECT_NEAR(held / 4000.0, 0.9854, 0.0076);  // four standard errors
}

TEST(Statistics, NothingHasNoPercentile) {
    EXPECT_THROW(percentile({}, 0.5), BugError);
    EXPECT_THROW(percentile({1.0}, 1.5), BugError);
}

TEST(Statistics, LineThroughExactPoints) {
    const auto line = fitLine({1.0, 2.0, 4.0}, {5.0, 7.0, 11.0});
    ASSERT_TRUE(line);
    EXPECT_DOUBLE_EQ(line->intercept, 3.0);
    EXPECT_DOUBLE_EQ(line->slope, 2.0);
}

TEST(Statistics, LineOfLeastSquaresBesideThePoints) {
    // Residuals 0.5, -1, 0.5 are orthogonal to 1 and x, so the line they were added to is the best one.
    const auto line = fitLine({0.0, 1.0, 2.0}, {10.5, 11.0, 14.5});
    ASSERT_TRUE(line);
    EXPECT_DOUBLE_EQ(line->intercept, 10.0);
    EXPECT_DOUBLE_EQ(line->slope, 2.0);
}

TEST(Statistics, NoLineThroughOnePlace) {
    EXPECT_FALSE(fitLine({}, {}));
    EXPECT_FALSE(fitLine({3.0}, {1.0}));
    EXPECT_FALSE(fitLine({3.0, 3.0}, {1.0, 2.0}));
}

/// Table 1 of KhemlicheBabahenini in milliseconds; the expected lines come from another program's polynomial fit.
TEST(Statistics, FitsOfTheSeedPapersTable) {
    const std::vector<double> vpls = {20, 50, 90, 200, 500, 800};
    const auto milliseconds = [](std::vector<double> fps) {
        for (double& value : fps) value = 1000.0 / value;
        return fps;
    };
    const auto forward = fitLine(vpls, milliseconds({38.09, 17.65, 9.62, 4.51, 1.81, 1.11}));
    const auto deferred = fitLine(vpls, milliseconds({40.16, 39.45, 30.01, 19.55, 9.87, 6.70}));
    ASSERT_TRUE(forward && deferred);
    EXPECT_NEAR(forward->slope, 1.118619, 1e-6);
    EXPECT_NEAR(forward->intercept, 0.845006, 1e-6);
    EXPECT_NEAR(deferred->slope, 0.162867, 1e-6);
    EXPECT_NEAR(deferred->intercept, 19.155621, 1e-6);
}

}  // namespace
}  // namespace manylight
