#include "tests/support/significance.h"

#include "engine/core/statistics.h"

#include <algorithm>
#include <cmath>

namespace manylight::test {
namespace {

constexpr int kMostTerms = 10000;
constexpr double kTiny = 1e-300;
constexpr double kEnough = 1e-15;

/// Continued fraction b0 + a1 / (b1 + a2 / (b2 + ...)) by the modified method of Lentz (1976). `term(i)` gives a_i,
/// b_i.
template <typename Term>
double continuedFraction(double b0, Term term) {
    double value = b0 == 0.0 ? kTiny : b0;
    double c = value;
    double d = 0.0;
    for (int i = 1; i < kMostTerms; ++i) {
        const auto [a, b] = term(i);
        d = b + a * d;
        c = b + a / c;
        if (std::abs(d) < kTiny) d = kTiny;
        if (std::abs(c) < kTiny) c = kTiny;
        d = 1.0 / d;
        value *= c * d;
        if (std::abs(c * d - 1.0) < kEnough) break;
    }
    return value;
}

struct Fraction {
    double a;
    double b;
};

}  // namespace

double upperGamma(double a, double x) {
    if (x <= 0.0) return 1.0;
    const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
    if (x < a + 1.0) {
        double term = 1.0 / a;
        double sum = term;
        for (int i = 1; i < kMostTerms && term > kEnough * sum; ++i) sum += term *= x / (a + i);
        return 1.0 - front * sum;
    }
    return front / continuedFraction(x + 1.0 - a, [&](int i) { return Fraction{-i * (i - a), x + 2.0 * i + 1.0 - a}; });
}

double incompleteBeta(double a, double b, double x) {
    if (x <= 0.0) return 0.0;
    if (x >= 1.0) return 1.0;
    // The fraction converges fast on one side of the mean; the other follows by symmetry.
    if (x > (a + 1.0) / (a + b + 2.0)) return 1.0 - incompleteBeta(b, a, 1.0 - x);
    const double front =
        std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x)) / a;
    return front / continuedFraction(1.0, [&](int i) {
               const int m = i / 2;
               const double numerator = i % 2 == 0 ? m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m))
                                                   : -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
               return Fraction{numerator, 1.0};
           });
}

double chiSquarePValue(double statistic, double degreesOfFreedom) {
    return upperGamma(0.5 * degreesOfFreedom, 0.5 * statistic);
}

double studentPValue(double t, double degreesOfFreedom) {
    return incompleteBeta(0.5 * degreesOfFreedom, 0.5, degreesOfFreedom / (degreesOfFreedom + t * t));
}

double chiSquareTest(const std::vector<double>& counts, const std::vector<double>& expected) {
    constexpr double kFewest = 5.0;
    double statistic = 0.0;
    double bins = 0.0;
    double pooledCount = 0.0;
    double pooledExpected = 0.0;
    const auto add = [&](double count, double mean) {
        statistic += (count - mean) * (count - mean) / mean;
        bins += 1.0;
    };
    for (size_t i = 0; i < counts.size(); ++i) {
        if (expected[i] <= 0.0 && counts[i] > 0.0) return 0.0;  // what cannot be, was
        if (expected[i] >= kFewest) {
            add(counts[i], expected[i]);
            continue;
        }
        pooledCount += counts[i];
        pooledExpected += expected[i];
        if (pooledExpected >= kFewest) {
            add(pooledCount, pooledExpected);
            pooledCount = pooledExpected = 0.0;
        }
    }
    if (pooledExpected > 0.0) add(pooledCount, pooledExpected);
    return bins > 1.0 ? chiSquarePValue(statistic, bins - 1.0) : 1.0;
}

double welchPValue(const std::vector<double>& a, const std::vector<double>& b) {
    const Estimate meanA = estimate(a);
    const Estimate meanB = estimate(b);
    const double squaredA = meanA.error * meanA.error;
    const double squaredB = meanB.error * meanB.error;
    const double squared = squaredA + squaredB;
    if (squared == 0.0) return meanA.mean == meanB.mean ? 1.0 : 0.0;
    const double degreesOfFreedom = squared * squared /
                                    (squaredA * squaredA / (static_cast<double>(a.size()) - 1.0) +
                                     squaredB * squaredB / (static_cast<double>(b.size()) - 1.0));
    return studentPValue((meanA.mean - meanB.mean) / std::sqrt(squared), degreesOfFreedom);
}

double sidak(double alpha, size_t count) {
    return -std::expm1(std::log1p(-alpha) / static_cast<double>(std::max<size_t>(count, 1)));
}

}  // namespace manylight::test
