#include "apps/bench/stability/findings.h"

#include "engine/core/finite.h"
#include "engine/core/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace manylight {
namespace {

constexpr double kStandardErrors = 5.0;
// Single precision may leave a mean off by this where samples hardly differ.
constexpr double kRoundingOfMean = 2e-6;

Verdict verdict(bool condition) { return condition ? Verdict::Holds : Verdict::Fails; }

double sumOf(const Image& image) {
    double sum = 0.0;
    for (const float value : image.texels) sum += double{value};
    return sum;
}

bool allFinite(const Image& image) { return std::all_of(image.texels.begin(), image.texels.end(), hasFiniteBits); }

bool sameSize(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && a.texels.size() == b.texels.size();
}

/// As `estimate`, with what rounding leaves open where samples hardly differ.
Estimate roundedEstimate(const std::vector<double>& samples) {
    const Estimate found = estimate(samples);
    return {found.mean, std::max(found.error, kRoundingOfMean * std::abs(found.mean))};
}

size_t nonZeroOf(const Image& image) {
    size_t count = 0;
    for (const float value : image.texels) count += value == 0.0f ? 0 : 1;  // NaN is not zero
    return count;
}

}  // namespace

Finding sameBytes(std::string what, const Image& image, const Image& reference) {
    size_t different = sameSize(image, reference) ? 0 : reference.texels.size();
    for (size_t i = 0; different == 0 && i < image.texels.size(); ++i)
        different += std::memcmp(&image.texels[i], &reference.texels[i], sizeof(float)) != 0 ? 1 : 0;
    return {std::move(what), "same bytes", different == 0 ? "same" : "different", verdict(different == 0)};
}

Finding exactlyScaled(std::string what, const Image& image, const Image& reference, int exponent) {
    size_t different = 0;
    for (size_t i = 0; i < reference.texels.size(); ++i)
        different += image.texels[i] == std::ldexp(reference.texels[i], exponent) ? 0 : 1;
    return {std::move(what), fmt::format("times 2^{}, exactly", exponent),
            fmt::format("{} of {} values off", different, reference.texels.size()),
            verdict(different == 0 && nonZeroOf(reference) > 0 && sameSize(image, reference))};
}

Finding allZero(std::string what, const Image& image) {
    const size_t count = nonZeroOf(image);
    return {std::move(what), "exactly 0", fmt::format("{} of {} values not 0", count, image.texels.size()),
            verdict(count == 0)};
}

Finding notBlack(std::string what, const Image& image) {
    const double sum = sumOf(image);
    return {std::move(what), "light", fmt::format("mean {:.4g}", sum / static_cast<double>(image.texels.size())),
            verdict(allFinite(image) && sum > 0.0)};
}

Finding closePictures(std::string what, const Image& image, const Image& reference, double tolerance) {
    const bool isComparable = sameSize(image, reference) && allFinite(image) && allFinite(reference);
    double difference = 0.0;
    for (size_t i = 0; i < reference.texels.size() && isComparable; ++i)
        difference += std::abs(double{image.texels[i]} - double{reference.texels[i]});
    const double relative = difference / sumOf(reference);
    return {std::move(what), fmt::format("differs by {:.0e} at most", tolerance), fmt::format("{:.1e}", relative),
            verdict(isComparable && relative <= tolerance)};
}

Finding closeTo(std::string what, double measured, double expected, double tolerance) {
    return {std::move(what), fmt::format("{:.7g} within {:.1e}", expected, tolerance), fmt::format("{:.7g}", measured),
            verdict(std::abs(measured - expected) <= tolerance * std::abs(expected))};
}

Finding countIs(std::string what, uint64_t measured, uint64_t expected) {
    return {std::move(what), fmt::format("{}", expected), fmt::format("{}", measured), verdict(measured == expected)};
}

Finding holds(std::string what, std::string expected, std::string measured, bool condition) {
    return {std::move(what), std::move(expected), std::move(measured), verdict(condition)};
}

Finding shown(std::string what, std::string expected, std::string measured) {
    return {std::move(what), std::move(expected), std::move(measured), Verdict::Shown};
}

Finding meanIs(std::string what, const std::vector<double>& samples, double expected, double largestError) {
    const Estimate sample = roundedEstimate(samples);
    const double deviation = (sample.mean - expected) / sample.error;
    return {std::move(what), fmt::format("{:.6g}", expected),
            fmt::format("{:.6g} +- {:.1e} ({:+.1f} s.e.)", sample.mean, sample.error, deviation),
            verdict(std::abs(deviation) < kStandardErrors && sample.error <= largestError * std::abs(expected))};
}

Finding meansAgree(std::string what, const std::vector<double>& samples, const std::vector<double>& reference,
                   double largestError) {
    const Estimate a = roundedEstimate(samples);
    const Estimate b = roundedEstimate(reference);
    const double error = std::hypot(a.error, b.error);
    const double deviation = (a.mean - b.mean) / error;
    return {std::move(what), fmt::format("{:.6g} +- {:.1e}", b.mean, b.error),
            fmt::format("{:.6g} +- {:.1e} ({:+.1f} s.e.)", a.mean, a.error, deviation),
            verdict(std::abs(deviation) < kStandardErrors && error <= largestError * std::abs(b.mean))};
}

}  // namespace manylight
