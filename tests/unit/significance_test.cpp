// The tests that other tests decide by: p-values from tables, and how often they reject what is true and what is not.
#include "tests/support/significance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace manylight::test {
namespace {

TEST(SignificanceTests, PValuesAreThoseOfTheTables) {
    // Two degrees of freedom have a closed form, and so has Student's t with one (Cauchy) and with two.
    for (const double x : {0.1, 1.0, 5.0, 30.0}) EXPECT_NEAR(chiSquarePValue(x, 2.0), std::exp(-0.5 * x), 1e-13);
    for (const double x : {0.1, 1.0, 5.0, 30.0})
        EXPECT_NEAR(chiSquarePValue(x, 1.0), std::erfc(std::sqrt(0.5 * x)), 1e-12);
    for (const double t : {0.1, 1.0, 5.0, 30.0}) {
        EXPECT_NEAR(studentPValue(t, 1.0), 1.0 - std::atan(t) / std::atan(1.0) / 2.0, 1e-12);
        EXPECT_NEAR(studentPValue(-t, 2.0), 1.0 - t / std::sqrt(2.0 + t * t), 1e-12);
    }
    // Percentage points from tables.
    EXPECT_NEAR(chiSquarePValue(124.342, 100.0), 0.05, 1e-6);
    EXPECT_NEAR(studentPValue(2.131450, 15.0), 0.05, 1e-7);
    EXPECT_NEAR(studentPValue(3.645959, 30.0), 0.001, 1e-8);
    EXPECT_EQ(chiSquarePValue(0.0, 7.0), 1.0);
    EXPECT_EQ(studentPValue(0.0, 7.0), 1.0);
}

TEST(SignificanceTests, ManyTestsAtOnceAskMoreOfEach) {
    EXPECT_DOUBLE_EQ(sidak(0.01, 1), 0.01);
    EXPECT_NEAR(1.0 - std::pow(1.0 - sidak(0.01, 36), 36.0), 0.01, 1e-15);
}

/// Share of 4000 comparisons, of 16 normal samples and 16 of half their spread, that Welch's test rejects.
double shareRejected(double shift, double alpha) {
    constexpr int kTrials = 4000;
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    int rejected = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<double> a(16);
        std::vector<double> b(16);
        for (double& sample : a) sample = normal(random);
        for (double& sample : b) sample = 0.5 * normal(random) + shift;
        rejected += welchPValue(a, b) < alpha ? 1 : 0;
    }
    return static_cast<double>(rejected) / kTrials;
}

TEST(SignificanceTests, WelchRejectsWhatIsTrueAsOftenAsItSays) {
    for (const double alpha : {0.2, 0.05, 0.01}) {
        const double error = std::sqrt(alpha * (1.0 - alpha) / 4000.0);
        EXPECT_NEAR(shareRejected(0.0, alpha), alpha, 4.0 * error) << alpha;
    }
}

TEST(SignificanceTests, WelchRejectsShiftedSamples) {
    // The standard error of the difference is sqrt(1.25 / 16) = 0.28. At 5 of these, a normal variable is beyond
    // the 3.8 that t of 22 degrees of freedom asks for at 0.001 about 9 times in 10.
    EXPECT_GT(shareRejected(5.0 * 0.28, 0.001), 0.8);
    EXPECT_GT(shareRejected(8.0 * 0.28, 0.001), 0.995);
    EXPECT_LT(shareRejected(1.0 * 0.28, 0.001), 0.05);
}

TEST(SignificanceTests, WelchComparesConstantsExactly) {
    const std::vector<double> two(5, 2.0);
    EXPECT_EQ(welchPValue(two, two), 1.0);
    EXPECT_EQ(welchPValue(two, std::vector<double>(5, 2.0000001)), 0.0);
}

TEST(SignificanceTests, ChiSquareRejectsWhatIsTrueAsOftenAsItSays) {
    // Bins of every size, some to be pooled.
    const std::vector<double> probabilities = {0.4, 0.3, 0.2, 0.05, 0.02, 0.01, 0.01, 0.004, 0.003, 0.003};
    constexpr int kTrials = 4000;
    std::mt19937 random(5);
    std::discrete_distribution<size_t> distribution(probabilities.begin(), probabilities.end());
    int rejected = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<double> counts(probabilities.size());
        std::vector<double> expected(probabilities.size());
        for (int i = 0; i < 500; ++i) counts[distribution(random)] += 1.0;
        for (size_t i = 0; i < expected.size(); ++i) expected[i] = 500.0 * probabilities[i];
        rejected += chiSquareTest(counts, expected) < 0.05 ? 1 : 0;
    }
    // The statistic is chi-square in the limit only: hence a little more than four standard errors of a share.
    EXPECT_NEAR(static_cast<double>(rejected) / kTrials, 0.05, 0.02);
}

TEST(SignificanceTests, ChiSquareRejectsWhatCannotBe) {
    EXPECT_EQ(chiSquareTest({50.0, 49.0, 1.0}, {50.0, 50.0, 0.0}), 0.0);
    EXPECT_LT(chiSquareTest({600.0, 400.0}, {500.0, 500.0}), 1e-9);
    EXPECT_EQ(chiSquareTest({500.0, 500.0}, {500.0, 500.0}), 1.0);
}

}  // namespace
}  // namespace manylight::test
