// Order statistics and line fits, for timings.
#pragma once

#include <optional>
#include <vector>

namespace manylight {

/// The value that a share `fraction` (0 to 1) of `values` lies below, linear between neighbours in order. `values` must
/// not be empty and hold no NaN.
double percentile(std::vector<double> values, double fraction);

double median(std::vector<double> values);

/// Median, 5th and 95th percentile.
struct Spread {
    double median = 0.0;
    double p5 = 0.0;
    double p95 = 0.0;
};
Spread spreadOf(const std::vector<double>& values);

struct Interval {
    double low = 0.0;
    double high = 0.0;
};
/// Where the median of the distribution lies with at least 95 % confidence, whatever its shape: between the values whose
/// ranks are 0.98 sqrt(n) away from the middle (Conover 1999, section 3.2). With fewer than 6, all: 94 % for five. Not empty.
Interval intervalOfMedian(std::vector<double> values);

/// Mean of independent samples, and the standard error of that mean: 0 for a single one.
struct Estimate {
    double mean = 0.0;
    double error = 0.0;
};
/// `samples` must not be empty. Sums in order.
Estimate estimate(const std::vector<double>& samples);

/// y = intercept + slope * x.
struct Line {
    double intercept = 0.0;
    double slope = 0.0;
};
/// The line of least squares in y; empty without two different x. As many ys as xs.
std::optional<Line> fitLine(const std::vector<double>& xs, const std::vector<double>& ys);

}  // namespace manylight
