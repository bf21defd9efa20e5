#include "engine/core/statistics.h"

#include "engine/core/check.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace manylight {
namespace {

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// `sorted` ascending.
double percentileOfSorted(const std::vector<double>& sorted, double fraction) {
    MANYLIGHT_CHECK(sorted.size() > 0u, "percentile of nothing");
    MANYLIGHT_CHECK((fraction >= 0.0 && fraction <= 1.0), "fraction {}", fraction);
    const double place = fraction * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<size_t>(place);
    const size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

}  // namespace

double percentile(std::vector<double> values, double fraction) {
    std::sort(values.begin(), values.end());
    return percentileOfSorted(values, fraction);
}

double median(std::vector<double> values) { return percentile(std::move(values), 0.5); }

Spread spreadOf(const std::vector<double>& values) {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    return {percentileOfSorted(sorted, 0.5), percentileOfSorted(sorted, 0.05), percentileOfSorted(sorted, 0.95)};
}

Interval intervalOfMedian(std::vector<double> values) {
    MANYLIGHT_CHECK(!values.empty(), "a median");
    std::sort(values.begin(), values.end());
    const auto count = static_cast<double>(values.size());
    constexpr double kHalfOfNormal95 = 0.98;  // 1.96 standard deviations, sqrt(n) / 2 each
    const double below = std::floor(count / 2.0 - kHalfOfNormal95 * std::sqrt(count));  // counted from 1
    const auto rank = static_cast<size_t>(std::max(below - 1.0, 0.0));
    return {values[rank], values[values.size() - 1 - rank]};
}

Estimate estimate(const std::vector<double>& samples) {
    MANYLIGHT_CHECK(!samples.empty(), "a mean");
    const auto count = static_cast<double>(samples.size());
    const double center = mean(samples);
    double squares = 0.0;
    for (const double sample : samples) squares += (sample - center) * (sample - center);
    return {center, count > 1.0 ? std::sqrt(squares / (count * (count - 1.0))) : 0.0};
}

std::optional<Line> fitLine(const std::vector<double>& xs, const std::vector<double>& ys) {
    MANYLIGHT_CHECK(xs.size() == ys.size(), "points of a line");
    if (xs.empty()) return std::nullopt;
    // About the means, so that far-off points lose no digits.
    const double meanX = mean(xs);
    const double meanY = mean(ys);
    double squares = 0.0;
    double products = 0.0;
    for (size_t i = 0; i < xs.size(); ++i) {
        squares += (xs[i] - meanX) * (xs[i] - meanX);
        products += (xs[i] - meanX) * (ys[i] - meanY);
    }
    if (squares == 0.0) return std::nullopt;
    const double slope = products / squares;
    return Line{meanY - slope * meanX, slope};
}

}  // namespace manylight
