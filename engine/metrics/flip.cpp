#include "engine/metrics/flip.h"

#include "engine/core/check.h"
#include "engine/metrics/luminance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manylight {
namespace {

/// (a x² + b x) / (c x² + d x + e), Narkowicz2016's fit of the ACES curve to a value that was exposed for it.
struct ToneCurve {
    float a, b, c, d, e;
    float operator()(float x) const { return (x * (a * x + b)) / (x * (c * x + d) + e); }
};
constexpr float kExposure = 0.6f;  // undone in the curve: 1 shall stay about 0.8
constexpr ToneCurve kToneCurve{2.51f * kExposure * kExposure, 0.03f * kExposure, 2.43f * kExposure* kExposure,
                               0.59f * kExposure, 0.14f};
constexpr float kSaturation = 1e6f;  // the curve has passed 1 long before; its square is still finite

/// The value that the curve takes to 0.85: what the brightest or the median pixel is exposed to.
double brightestShown() {
    constexpr double kTarget = 0.85;
    const double a = double{kToneCurve.a} - kTarget * double{kToneCurve.c};
    const double b = double{kToneCurve.b} - kTarget * double{kToneCurve.d};
    const double c = -kTarget * double{kToneCurve.e};
    return (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

/// Channel planes of the picture after `show`, black where it is not finite in either picture.
template <typename Show>
DisplayPlanes displayPlanes(const Image& image, const std::vector<uint8_t>& isFinite, const Show& show) {
    DisplayPlanes planes{{image.width, image.height}, {image.width, image.height}, {image.width, image.height}};
    for (size_t i = 0; i < isFinite.size(); ++i) {
        const float* texel = &image.texels[i * 3];
        planes.red.values[i] = isFinite[i] ? show(texel[0]) : 0.0f;
        planes.green.values[i] = isFinite[i] ? show(texel[1]) : 0.0f;
        planes.blue.values[i] = isFinite[i] ? show(texel[2]) : 0.0f;
    }
    return planes;
}

/// What is on the screen at `exposure` stops.
DisplayPlanes exposed(const Image& image, const std::vector<uint8_t>& isFinite, double exposure) {
    const double gain = std::exp2(exposure);
    return displayPlanes(image, isFinite, [gain](float value) {
        const double bright = std::clamp(gain * double{value}, -1.0 * kSaturation, 1.0 * kSaturation);
        return std::clamp(kToneCurve(static_cast<float>(bright)), 0.0f, 1.0f);
    });
}

void keepLarger(Plane& largest, const Plane& map) {
    for (size_t i = 0; i < map.values.size(); ++i) largest.values[i] = std::max(largest.values[i], map.values[i]);
}

/// What both kinds of FLIP begin and end with.
struct Comparison {
    std::vector<uint8_t> isFinite;  // in both pictures, masked out or not
    PixelUse use;
};

Comparison comparisonOf(const Image& test, const Image& reference, const FlipOptions& options) {
    MANYLIGHT_CHECK(reference.channels == 3u, "pictures to compare");
    MANYLIGHT_CHECK(options.pixelsPerDegree >= kMinPixelsPerDegree, "FLIP");
    MANYLIGHT_CHECK(kMaxPixelsPerDegree >= options.pixelsPerDegree, "FLIP");
    Comparison comparison{pixelUse(test, reference).uses, pixelUse(test, reference, options.mask)};
    if (comparison.use.compared == 0) fail("no pixel left to compare");
    return comparison;
}

FlipResult resultOf(const Plane& map, const Comparison& comparison, const FlipExposures& exposures) {
    FlipResult result;
    result.exposures = exposures;
    result.pixels = comparison.use.compared;
    result.nonFinite = comparison.use.nonFinite;
    result.map = Image(static_cast<uint32_t>(map.width), static_cast<uint32_t>(map.height), 1);
    double sum = 0.0;
    for (size_t i = 0; i < map.values.size(); ++i) {
        result.map.texels[i] = comparison.isFinite[i] ? map.values[i] : std::numeric_limits<float>::quiet_NaN();
        if (comparison.use.uses[i]) sum += double{map.values[i]};
    }
    result.mean = sum / static_cast<double>(result.pixels);
    return result;
}

}  // namespace

std::optional<FlipExposures> flipExposures(const Image& reference, const std::vector<uint8_t>& uses) {
    std::vector<double> luminances;
    luminances.reserve(uses.size());
    for (size_t i = 0; i < uses.size(); ++i)
        if (uses[i]) luminances.push_back(luminanceOf(&reference.texels[i * 3]));
    if (luminances.empty()) return std::nullopt;
    const double brightest = *std::max_element(luminances.begin(), luminances.end());
    if (!(brightest > 0.0)) return std::nullopt;

    // The evaluator's floor, for pictures that are black for the most part; it has none for pictures below the floor.
    constexpr double kFloor = std::numeric_limits<float>::epsilon();
    const auto middle = luminances.begin() + static_cast<ptrdiff_t>(luminances.size() / 2);
    std::nth_element(luminances.begin(), middle, luminances.end());
    const double median = std::max(*middle, brightest > kFloor ? kFloor : kFloor * brightest);

    // In float, as the evaluator has it: its number of exposures then agrees even where the range is a whole number.
    const auto start = static_cast<float>(std::log2(brightestShown() / brightest));
    const auto stop = static_cast<float>(std::log2(brightestShown() / median));
    return FlipExposures{start, stop, static_cast<uint32_t>(std::max(2.0f, std::ceil(stop - start)))};
}

std::optional<FlipResult> hdrFlip(const Image& test, const Image& reference, const FlipOptions& options) {
    const Comparison comparison = comparisonOf(test, reference, options);
    const std::optional<FlipExposures> exposures = flipExposures(reference, comparison.use.uses);
    if (!exposures) return std::nullopt;

    const FlipFilters filters = flipFilters(options.pixelsPerDegree);
    Plane largest(reference.width, reference.height);
    for (uint32_t i = 0; i < exposures->count; ++i) {
        const auto perceived = [&](const Image& image) {
            return perceive(exposed(image, comparison.isFinite, exposures->at(i)), filters);
        };
        keepLarger(largest, flipDifference(perceived(test), perceived(reference)));
    }
    return resultOf(largest, comparison, *exposures);
}

HdrFlipReference::HdrFlipReference(Image reference, const FlipOptions& options)
    : reference_(std::move(reference)), options_(options), filters_(flipFilters(options.pixelsPerDegree)) {
    const Comparison comparison = comparisonOf(reference_, reference_, options_);
    isFinite_ = comparison.isFinite;
    exposures_ = flipExposures(reference_, comparison.use.uses);
    for (uint32_t i = 0; exposures_ && i < exposures_->count; ++i)
        perceived_.push_back(perceive(exposed(reference_, isFinite_, exposures_->at(i)), filters_));
}

std::optional<FlipResult> HdrFlipReference::compare(const Image& test) const {
    const Comparison comparison = comparisonOf(test, reference_, options_);
    // More black pixels in the test are more in the reference too.
    if (comparison.isFinite != isFinite_) return hdrFlip(test, reference_, options_);
    if (!exposures_) return std::nullopt;
    Plane largest(reference_.width, reference_.height);
    for (uint32_t i = 0; i < exposures_->count; ++i) {
        const Perceived perceivedTest = perceive(exposed(test, isFinite_, exposures_->at(i)), filters_);
        keepLarger(largest, flipDifference(perceivedTest, perceived_[i]));
    }
    return resultOf(largest, comparison, *exposures_);
}

FlipResult ldrFlip(const Image& test, const Image& reference, const FlipOptions& options) {
    const Comparison comparison = comparisonOf(test, reference, options);
    const FlipFilters filters = flipFilters(options.pixelsPerDegree);
    const auto perceived = [&](const Image& image) {
        const auto show = [](float value) { return std::clamp(value, 0.0f, 1.0f); };
        return perceive(displayPlanes(image, comparison.isFinite, show), filters);
    };
    return resultOf(flipDifference(perceived(test), perceived(reference)), comparison, {});
}

}  // namespace manylight
