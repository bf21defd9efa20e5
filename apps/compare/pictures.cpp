#include "apps/compare/pictures.h"

#include "engine/core/error.h"
#include "engine/core/finite.h"
#include "engine/core/statistics.h"
#include "engine/image/image_io.h"
#include "engine/image/srgb.h"
#include "engine/metrics/false_colour.h"
#include "engine/metrics/luminance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace manylight {
namespace {

constexpr double kQuantileAtEnds = 0.99;
constexpr double kSmallestRange = 1e-6;
const glm::vec3 kMaskedOut(0.25f);  // in neither scale

/// 1, 2 or 5 times a power of ten, not below `value`.
double roundedUp(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (value <= factor * power * (1.0 + 1e-9)) return factor * power;
    return 10.0 * power;
}

/// colour(pixel) is an sRGB code value, or NaN for a pixel that is not finite.
template <typename Colour>
void writeFalseColour(const std::filesystem::path& path, const CompareInputs& inputs, const Colour& colour) {
    Image picture(inputs.reference.width, inputs.reference.height, 3);
    for (size_t i = 0; i < picture.texels.size() / 3; ++i) {
        const bool isMaskedOut = inputs.mask && !inputs.mask->uses[i];
        const glm::vec3 code = isMaskedOut ? kMaskedOut : colour(i);
        for (glm::length_t c = 0; c < 3; ++c) picture.texels[i * 3 + static_cast<size_t>(c)] = decodeSrgb(code[c]);
    }
    writePng(path, picture);
}

const glm::vec3 kNotFinite(std::numeric_limits<float>::quiet_NaN());

}  // namespace

std::string writeDifference(const std::filesystem::path& path, const CompareInputs& inputs, const ErrorReport& error,
                            std::optional<double> range) {
    if (!(error.meanLuminanceReference > 0.0))
        fail("{}: no relative error to show: the reference's mean luminance is {}", path.string(),
             error.meanLuminanceReference);
    const PixelUse use = pixelUse(inputs.test, inputs.reference, inputs.mask ? &*inputs.mask : nullptr);
    std::vector<double> relative(use.uses.size());
    std::vector<double> sizes;
    for (size_t i = 0; i < relative.size(); ++i) {
        if (!use.uses[i]) continue;
        const double y = luminanceOf(&inputs.test.texels[i * 3]) / error.meanLuminanceReference;
        const double expected = luminanceOf(&inputs.reference.texels[i * 3]) / error.meanLuminanceReference;
        relative[i] = (y - expected) / std::sqrt(expected * expected + kRelativeErrorEpsilon);
        sizes.push_back(std::abs(relative[i]));
    }
    const double end = range ? *range : roundedUp(std::max(percentile(sizes, kQuantileAtEnds), kSmallestRange));
    writeFalseColour(path, inputs, [&](size_t i) {
        return use.uses[i] ? blueGreyRed(static_cast<float>(relative[i] / end)) : kNotFinite;
    });
    const auto beyond = std::count_if(sizes.begin(), sizes.end(), [end](double size) { return size > end; });
    return fmt::format(
        "{}: blue {:+.6g} % or less, grey 0, red {:+.6g} % or more; beyond the scale {:.2f} % of the pixels\n",
        path.string(), -100.0 * end, 100.0 * end,
        100.0 * static_cast<double>(beyond) / static_cast<double>(sizes.size()));
}

std::string writeFlipMap(const std::filesystem::path& path, const CompareInputs& inputs, const FlipResult& flip) {
    writeFalseColour(path, inputs, [&](size_t i) {
        return hasFiniteBits(flip.map.texels[i]) ? magma(flip.map.texels[i]) : kNotFinite;
    });
    return fmt::format("{}: FLIP, black 0, purple 0.25, red 0.5, orange 0.75, pale yellow 1\n", path.string());
}

}  // namespace manylight
