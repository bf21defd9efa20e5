#include "engine/metrics/error.h"

#include "engine/core/check.h"
#include "engine/metrics/luminance.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

void addMeans(ErrorReport& report, const Image& test, const Image& reference, const std::vector<uint8_t>& uses) {
    for (size_t i = 0; i < uses.size(); ++i) {
        if (!uses[i]) continue;
        for (size_t c = 0; c < 3; ++c) {
            report.meanTest[c] += double{test.texels[i * 3 + c]};
            report.meanReference[c] += double{reference.texels[i * 3 + c]};
        }
        report.meanLuminanceReference += luminanceOf(&reference.texels[i * 3]);
    }
    const auto count = static_cast<double>(report.pixels);
    report.meanLuminanceReference /= count;
    for (size_t c = 0; c < 3; ++c) {
        report.meanTest[c] /= count;
        report.meanReference[c] /= count;
    }
}

/// Squared error of each compared pixel, its channels summed.
std::vector<double> squaredErrors(const Image& test, const Image& reference, const PixelUse& use) {
    std::vector<double> squares;
    squares.reserve(use.compared);
    for (size_t i = 0; i < use.uses.size(); ++i) {
        if (!use.uses[i]) continue;
        double square = 0.0;
        for (size_t c = 0; c < 3; ++c) {
            const double difference = double{test.texels[i * 3 + c]} - double{reference.texels[i * 3 + c]};
            square += difference * difference;
        }
        squares.push_back(square);
    }
    return squares;
}

void addSquaredErrors(ErrorReport& report, const std::vector<double>& squares) {
    const size_t count = squares.size();
    const auto worstCount = static_cast<size_t>(std::ceil(kWorstPixelShare * static_cast<double>(count)));
    std::vector<double> order = squares;
    const auto firstWorst = order.end() - static_cast<ptrdiff_t>(worstCount);
    std::nth_element(order.begin(), firstWorst, order.end());
    const double threshold = *firstWorst;

    // Summed by value, not by place in `order`: that depends on the library's selection algorithm.
    double worst = 0.0;
    double others = 0.0;
    size_t above = 0;
    size_t below = 0;
    for (const double square : squares) {
        if (square > threshold) {
            worst += square;
            ++above;
        } else if (square < threshold) {
            others += square;
            ++below;
        }
    }
    worst += static_cast<double>(worstCount - above) * threshold;
    others += static_cast<double>(count - worstCount - below) * threshold;

    const double total = worst + others;
    report.rmse = std::sqrt(total / static_cast<double>(3 * count));
    report.worstPixels = worstCount;
    report.worstShare = total > 0.0 ? worst / total : 0.0;
    report.rmseWithoutWorst =
        count > worstCount ? std::sqrt(others / static_cast<double>(3 * (count - worstCount))) : 0;
}

void addRelativeErrors(ErrorReport& report, const Image& test, const Image& reference,
                       const std::vector<uint8_t>& uses) {
    if (!(report.meanLuminanceReference > 0.0)) return;
    const double scale = 1.0 / report.meanLuminanceReference;
    double squares = 0.0;
    double shares = 0.0;
    for (size_t i = 0; i < uses.size(); ++i) {
        if (!uses[i]) continue;
        for (size_t c = 0; c < 3; ++c) {
            const double v = double{test.texels[i * 3 + c]} * scale;
            const double r = double{reference.texels[i * 3 + c]} * scale;
            squares += (v - r) * (v - r) / (r * r + kRelativeErrorEpsilon);
            shares += std::abs(v - r) / (std::abs(v) + std::abs(r) + kRelativeErrorEpsilon);
        }
    }
    report.relativeMse = squares / static_cast<double>(3 * report.pixels);
    report.smape = shares / static_cast<double>(3 * report.pixels);
}

}  // namespace

ErrorReport compareImages(const Image& test, const Image& reference, const Mask* mask) {
    MANYLIGHT_CHECK(reference.channels == 3u, "pictures to compare");
    const PixelUse use = pixelUse(test, reference, mask);
    ErrorReport report;
    report.pixels = use.compared;
    report.maskedOut = use.maskedOut;
    report.nonFinite = use.nonFinite;
    report.nonFiniteTest = use.nonFiniteTest;
    report.nonFiniteReference = use.nonFiniteReference;
    if (report.pixels == 0)
        fail("no pixel left to compare: of {}, {} are masked out and {} not finite", use.uses.size(), use.maskedOut,
             use.nonFinite);
    addMeans(report, test, reference, use.uses);
    addSquaredErrors(report, squaredErrors(test, reference, use));
    addRelativeErrors(report, test, reference, use.uses);
    return report;
}

std::optional<double> meanRatio(const ErrorReport& report, size_t channel) {
    if (report.meanReference[channel] == 0.0) return std::nullopt;
    return report.meanTest[channel] / report.meanReference[channel];
}

}  // namespace manylight
