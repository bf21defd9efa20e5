// Statistics that tests decide by: p-values of Student's t and of chi-square, and what many tests at once may ask for.
#pragma once

#include <cstddef>
#include <vector>

namespace manylight::test {

/// Upper regularised incomplete gamma function, Q(a, x) = Gamma(a, x) / Gamma(a); a > 0, x >= 0.
double upperGamma(double a, double x);
/// Regularised incomplete beta function I_x(a, b); a, b > 0, 0 <= x <= 1.
double incompleteBeta(double a, double b, double x);

/// Chance that a chi-square variable of that many degrees of freedom is at least `statistic`.
double chiSquarePValue(double statistic, double degreesOfFreedom);
/// Chance that |t| or more comes up, of Student's t; `degreesOfFreedom` need not be a whole number.
double studentPValue(double t, double degreesOfFreedom);

/// Pearson's test that `counts` come from a distribution with those `expected` counts, of the same sum. Bins that
/// expect fewer than 5 are pooled.
double chiSquareTest(const std::vector<double>& counts, const std::vector<double>& expected);

/// Welch's test that two sets of samples, of any variances, have one mean. 1 where both are one constant.
double welchPValue(const std::vector<double>& a, const std::vector<double>& b);

/// Significance of each of `count` tests that are to be wrong together with probability `alpha` (Sidak 1967).
double sidak(double alpha, size_t count);

}  // namespace manylight::test
