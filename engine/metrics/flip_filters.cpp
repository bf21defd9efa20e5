#include "engine/metrics/flip_filters.h"

#include "shaders/shared/constants.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

constexpr double kPiSquared = double{shared::kPi} * double{shared::kPi};
constexpr double kWidestVariance = 0.04;         // b of the widest Gaussian, in degrees² * 2π²
constexpr double kFeatureWidth = 0.082;          // of an edge, in degrees
constexpr double kNegligible = 1.0 / (1 << 24);  // relative to the filter's largest weight

/// a sqrt(π / b) exp(-π² x² / b): the form in which FLIP states its contrast sensitivity, x in degrees.
struct Gaussian {
    double a;
    double b;
    double at(double x) const { return amplitude() * std::exp(-kPiSquared * x * x / b); }
    double amplitude() const { return a * std::sqrt(double{shared::kPi} / b); }
};

/// Sum over both halves.
double fullSum(const std::vector<double>& half) {
    double sum = half[0];
    for (size_t i = 1; i < half.size(); ++i) sum += 2.0 * half[i];
    return sum;
}

/// Scaled weights, without a tail that no float sum would notice.
HalfFilter halfFilter(const std::vector<double>& half, double scale, bool isOdd = false) {
    double largest = 0.0;
    for (const double weight : half) largest = std::max(largest, std::abs(weight));
    size_t size = half.size();
    while (size > 1 && std::abs(half[size - 1]) < kNegligible * largest) --size;
    HalfFilter filter{{}, isOdd};
    for (size_t i = 0; i < size; ++i) filter.weights.push_back(static_cast<float>(half[i] * scale));
    return filter;
}

std::vector<double> sample(const Gaussian& gaussian, size_t radius, double pixelsPerDegree) {
    std::vector<double> half;
    for (size_t i = 0; i <= radius; ++i) half.push_back(gaussian.at(static_cast<double>(i) / pixelsPerDegree));
    return half;
}

void setSpatialFilters(FlipFilters& filters, double pixelsPerDegree) {
    const double widest = std::sqrt(kWidestVariance / (2.0 * kPiSquared));
    const auto radius = static_cast<size_t>(std::ceil(3.0 * widest * pixelsPerDegree));
    const std::vector<double> luminance = sample({1.0, 0.0047}, radius, pixelsPerDegree);
    const std::vector<double> redGreen = sample({1.0, 0.0053}, radius, pixelsPerDegree);
    filters.luminance = halfFilter(luminance, 1.0 / fullSum(luminance));
    filters.redGreen = halfFilter(redGreen, 1.0 / fullSum(redGreen));

    // A sum of two Gaussians of the plane: each is a product of its square root's values along x and along y.
    std::vector<double> blueYellow[2];
    const Gaussian parts[2] = {{34.1, 0.04}, {13.5, 0.025}};
    double squares = 0.0;
    for (size_t part = 0; part < 2; ++part) {
        blueYellow[part] = sample(parts[part], radius, pixelsPerDegree);
        for (double& weight : blueYellow[part]) weight /= std::sqrt(parts[part].amplitude());
        squares += fullSum(blueYellow[part]) * fullSum(blueYellow[part]);
    }
    for (size_t part = 0; part < 2; ++part)
        filters.blueYellow[part] = halfFilter(blueYellow[part], 1.0 / std::sqrt(squares));
}

/// A Gaussian and its first two derivatives; the positive and the negative weights of a derivative sum to 1 and -1.
void setFeatureFilters(FlipFilters& filters, double pixelsPerDegree) {
    const double deviation = 0.5 * kFeatureWidth * pixelsPerDegree;
    const auto radius = static_cast<size_t>(std::ceil(3.0 * deviation));
    std::vector<double> gaussian;
    std::vector<double> edge;
    std::vector<double> point;
    for (size_t i = 0; i <= radius; ++i) {
        const double place = static_cast<double>(i) / deviation;
        gaussian.push_back(std::exp(-0.5 * place * place));
        edge.push_back(place * gaussian.back());
        point.push_back((place * place - 1.0) * gaussian.back());
    }

    double edgeSum = 0.0;
    double positive = 0.0;
    double negative = 0.0;
    for (size_t i = 0; i <= radius; ++i) {
        const double copies = i == 0 ? 1.0 : 2.0;
        edgeSum += edge[i];
        positive += copies * std::max(point[i], 0.0);
        negative += copies * std::max(-point[i], 0.0);
    }
    for (double& weight : point) weight /= weight > 0.0 ? positive : negative;
    filters.gaussian = halfFilter(gaussian, 1.0 / fullSum(gaussian));
    filters.edge = halfFilter(edge, 1.0 / edgeSum, true);
    filters.point = halfFilter(point, 1.0);
}

/// sums[x] += weight * (right[x] + left[x]), or the difference for an odd filter.
void addPair(float* sums, const float* right, const float* left, float weight, bool isOdd, size_t count) {
    if (isOdd)
        for (size_t x = 0; x < count; ++x) sums[x] += weight * (right[x] - left[x]);
    else
        for (size_t x = 0; x < count; ++x) sums[x] += weight * (right[x] + left[x]);
}

}  // namespace

FlipFilters flipFilters(double pixelsPerDegree) {
    FlipFilters filters;
    setSpatialFilters(filters, pixelsPerDegree);
    setFeatureFilters(filters, pixelsPerDegree);
    return filters;
}

Plane filterRows(const Plane& plane, const HalfFilter& filter) {
    const size_t radius = filter.weights.size() - 1;
    Plane result(plane.width, plane.height);
    std::vector<float> padded(plane.width + 2 * radius);
    float* const center = padded.data() + radius;
    for (size_t y = 0; y < plane.height; ++y) {
        const float* source = plane.row(y);
        std::fill_n(padded.data(), radius, source[0]);
        std::copy_n(source, plane.width, center);
        std::fill_n(center + plane.width, radius, source[plane.width - 1]);

        float* sums = result.row(y);
        for (size_t x = 0; x < plane.width; ++x) sums[x] = filter.weights[0] * center[x];
        for (size_t i = 1; i <= radius; ++i)
            addPair(sums, center + i, center - i, filter.weights[i], filter.isOdd, plane.width);
    }
    return result;
}

Plane filterColumns(const Plane& plane, const HalfFilter& filter) {
    const size_t radius = filter.weights.size() - 1;
    Plane result(plane.width, plane.height);
    for (size_t y = 0; y < plane.height; ++y) {
        float* sums = result.row(y);
        const float* source = plane.row(y);
        for (size_t x = 0; x < plane.width; ++x) sums[x] = filter.weights[0] * source[x];
        for (size_t i = 1; i <= radius; ++i) {
            const float* below = plane.row(std::min(y + i, plane.height - 1));
            const float* above = plane.row(y >= i ? y - i : 0);
            addPair(sums, below, above, filter.weights[i], filter.isOdd, plane.width);
        }
    }
    return result;
}

}  // namespace manylight
