#include "engine/metrics/flip_perception.h"

#include "engine/metrics/flip_colour.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

using namespace perception;

constexpr float kColourExponent = 0.7f;  // q_c
constexpr float kMostBelowKnee = 0.4f;   // p_c: the share of the largest difference that ...
constexpr float kKnee = 0.95f;           // p_t: ... takes this share of the result

/// Luminance Y, X - Y (red to green) and Y - Z (blue to yellow), all relative to white: YCxCz without its scales.
struct Opponent {
    Plane luminance;
    Plane redGreen;
    Plane blueYellow;
};

Opponent opponentOf(const DisplayPlanes& picture) {
    const size_t width = picture.red.width;
    const size_t height = picture.red.height;
    Opponent opponent{Plane(width, height), Plane(width, height), Plane(width, height)};
    const Matrix xyzFromRgb = colourSpace().xyzFromRgb;
    for (size_t y = 0; y < height; ++y) {
        const float* red = picture.red.row(y);
        const float* green = picture.green.row(y);
        const float* blue = picture.blue.row(y);
        float* luminance = opponent.luminance.row(y);
        float* redGreen = opponent.redGreen.row(y);
        float* blueYellow = opponent.blueYellow.row(y);
        for (size_t x = 0; x < width; ++x) {
            const Triple xyz = xyzFromRgb * Triple{red[x], green[x], blue[x]};
            luminance[x] = xyz.y;
            redGreen[x] = xyz.x - xyz.y;
            blueYellow[x] = xyz.y - xyz.z;
        }
    }
    return opponent;
}

float toGamut(float value) { return std::min(std::max(value, 0.0f), 1.0f); }

Plane filterBoth(const Plane& plane, const HalfFilter& rows, const HalfFilter& columns) {
    return filterColumns(filterRows(plane, rows), columns);
}

Plane filterBlueYellow(const Plane& plane, const HalfFilter (&parts)[2]) {
    Plane sum = filterBoth(plane, parts[0], parts[0]);
    const Plane second = filterBoth(plane, parts[1], parts[1]);
    for (size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += second.values[i];
    return sum;
}

/// Blurs as the eye does and leaves lightness, a and b in the three planes.
void toHuntLab(Opponent& opponent, const FlipFilters& filters) {
    opponent.luminance = filterBoth(opponent.luminance, filters.luminance, filters.luminance);
    opponent.redGreen = filterBoth(opponent.redGreen, filters.redGreen, filters.redGreen);
    opponent.blueYellow = filterBlueYellow(opponent.blueYellow, filters.blueYellow);

    const ColourSpace space = colourSpace();
    for (size_t row = 0; row < opponent.luminance.height; ++row) {
        float* luminance = opponent.luminance.row(row);
        float* redGreen = opponent.redGreen.row(row);
        float* blueYellow = opponent.blueYellow.row(row);
        for (size_t x = 0; x < opponent.luminance.width; ++x) {
            const float y = luminance[x];
            const Triple rgb = space.rgbFromXyz * Triple{y + redGreen[x], y, y - blueYellow[x]};
            // Channels blur differently: what falls out of the display's gamut thereby is brought back.
            const HuntLab lab = huntLab(space.xyzFromRgb * Triple{toGamut(rgb.x), toGamut(rgb.y), toGamut(rgb.z)});
            luminance[x] = lab.lightness;
            redGreen[x] = lab.a;
            blueYellow[x] = lab.b;
        }
    }
}

/// Length of the gradient of the blurred luminance, or of its second derivatives.
Plane featureStrength(const Plane& alongRows, const Plane& blurredRows, const HalfFilter& gaussian,
                      const HalfFilter& derivative) {
    Plane strength = filterColumns(alongRows, gaussian);
    const Plane alongColumns = filterColumns(blurredRows, derivative);
    for (size_t i = 0; i < strength.values.size(); ++i) {
        const float x = strength.values[i];
        const float y = alongColumns.values[i];
        strength.values[i] = std::sqrt(x * x + y * y);
    }
    return strength;
}

/// The largest difference between colours of the display, green and blue, and the knee of the map to [0, 1].
struct ColourRange {
    float largest;
    float knee;
};

ColourRange colourRange() {
    const Matrix& xyzFromRgb = colourSpace().xyzFromRgb;
    const HuntLab green = huntLab(xyzFromRgb * Triple{0.0f, 1.0f, 0.0f});
    const HuntLab blue = huntLab(xyzFromRgb * Triple{0.0f, 0.0f, 1.0f});
    const float largest = std::pow(colourDistance(green, blue), kColourExponent);
    return {largest, kMostBelowKnee * largest};
}

float toUnitRange(float difference, const ColourRange& range) {
    if (difference < range.knee) return difference * (kKnee / range.knee);
    return kKnee + (difference - range.knee) / (range.largest - range.knee) * (1.0f - kKnee);
}

}  // namespace

Perceived perceive(const DisplayPlanes& picture, const FlipFilters& filters) {
    Opponent opponent = opponentOf(picture);
    const Plane blurredRows = filterRows(opponent.luminance, filters.gaussian);
    Plane edge =
        featureStrength(filterRows(opponent.luminance, filters.edge), blurredRows, filters.gaussian, filters.edge);
    Plane point =
        featureStrength(filterRows(opponent.luminance, filters.point), blurredRows, filters.gaussian, filters.point);
    toHuntLab(opponent, filters);
    return {std::move(opponent.luminance), std::move(opponent.redGreen), std::move(opponent.blueYellow),
            std::move(edge), std::move(point)};
}

Plane flipDifference(const Perceived& test, const Perceived& reference) {
    static const ColourRange kRange = colourRange();
    const float perFeature = std::sqrt(0.5f);
    Plane result(test.lightness.width, test.lightness.height);
    for (size_t i = 0; i < result.values.size(); ++i) {
        const HuntLab p{test.lightness.values[i], test.a.values[i], test.b.values[i]};
        const HuntLab q{reference.lightness.values[i], reference.a.values[i], reference.b.values[i]};
        const float colour = toUnitRange(std::pow(colourDistance(p, q), kColourExponent), kRange);
        const float edge = std::abs(test.edge.values[i] - reference.edge.values[i]);
        const float point = std::abs(test.point.values[i] - reference.point.values[i]);
        const float feature = std::sqrt(perFeature * std::max(edge, point));  // the root is q_f = 0.5
        result.values[i] = std::pow(colour, std::max(1.0f - feature, 0.0f));
    }
    return result;
}

}  // namespace manylight
