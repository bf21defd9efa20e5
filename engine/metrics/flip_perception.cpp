#include "engine/metrics/flip_perception.h"

#include <glm/glm.hpp>

#include <bit>
#include <cmath>
#include <cstdint>

namespace manylight {
namespace {

constexpr float kColourExponent = 0.7f;      // q_c
constexpr float kMostBelowKnee = 0.4f;       // p_c: the share of the largest difference that ...
constexpr float kKnee = 0.95f;               // p_t: ... takes this share of the result
constexpr float kFeatureExponent = 0.5f;     // q_f; a square root below

/// Linear RGB with sRGB's primaries to XYZ over the XYZ of white, whose rows therefore sum to 1 each.
const glm::dmat3& relativeXyzFromRgb() {
    static const glm::dmat3 matrix = [] {
        // IEC 61966-2-1, row by row; GLM takes columns.
        glm::dmat3 xyzFromRgb = glm::transpose(glm::dmat3(0.412386563, 0.357591491, 0.180450491,  //
                                                          0.212636822, 0.715182982, 0.072180196,  //
                                                          0.019330620, 0.119197164, 0.950372587));
        const glm::dvec3 white = xyzFromRgb * glm::dvec3(1.0);
        for (glm::length_t column = 0; column < 3; ++column) xyzFromRgb[column] /= white;
        return xyzFromRgb;
    }();
    return matrix;
}

/// Cube root of a value in [0.001, 2], to float precision: a guess from the exponent and two of Halley's steps. The
/// library's function does not vectorise.
float cubeRoot(float value) {
    constexpr float kExponentBias = 127.0f * (1 << 23) * (2.0f / 3.0f);
    const float bits = static_cast<float>(std::bit_cast<int32_t>(value));
    float root = std::bit_cast<float>(static_cast<int32_t>(bits * (1.0f / 3.0f) + kExponentBias));
    for (int step = 0; step < 2; ++step) {
        const float cube = root * root * root;
        root *= (cube + 2.0f * value) / (2.0f * cube + value);
    }
    return root;
}

/// CIELAB's compression of a relative tristimulus value in [0, 1].
float compress(float value) {
    constexpr float kDelta = 6.0f / 29.0f;
    constexpr float kThreshold = kDelta * kDelta * kDelta;
    const float line = value / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
    const float root = cubeRoot(std::max(value, kThreshold));
    return value > kThreshold ? root : line;
}

struct HuntLab {
    float lightness;
    float a;
    float b;
};

/// `xyz` relative to white. The chroma shrinks with the lightness, as Hunt's effect has it.
HuntLab huntLab(const glm::vec3& xyz) {
    const float x = compress(xyz.x);
    const float y = compress(xyz.y);
    const float z = compress(xyz.z);
    const float lightness = 116.0f * y - 16.0f;
    const float scale = 0.01f * lightness;
    return {lightness, scale * 500.0f * (x - y), scale * 200.0f * (y - z)};
}

/// HyAB: city block in lightness, Euclidean in chroma.
float distance(const HuntLab& p, const HuntLab& q) {
    const float a = p.a - q.a;
    const float b = p.b - q.b;
    return std::abs(p.lightness - q.lightness) + std::sqrt(a * a + b * b);
}

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
    const glm::mat3 xyzFromRgb(relativeXyzFromRgb());
    for (size_t i = 0; i < width * height; ++i) {
        const glm::vec3 xyz =
            xyzFromRgb * glm::vec3(picture.red.values[i], picture.green.values[i], picture.blue.values[i]);
        opponent.luminance.values[i] = xyz.y;
        opponent.redGreen.values[i] = xyz.x - xyz.y;
        opponent.blueYellow.values[i] = xyz.y - xyz.z;
    }
    return opponent;
}

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

    const glm::mat3 xyzFromRgb(relativeXyzFromRgb());
    const glm::mat3 rgbFromXyz(glm::inverse(relativeXyzFromRgb()));
    for (size_t i = 0; i < opponent.luminance.values.size(); ++i) {
        const float y = opponent.luminance.values[i];
        const glm::vec3 xyz(y + opponent.redGreen.values[i], y, y - opponent.blueYellow.values[i]);
        // Channels blur differently: what falls out of the display's gamut thereby is brought back.
        const HuntLab lab = huntLab(xyzFromRgb * glm::clamp(rgbFromXyz * xyz, 0.0f, 1.0f));
        opponent.luminance.values[i] = lab.lightness;
        opponent.redGreen.values[i] = lab.a;
        opponent.blueYellow.values[i] = lab.b;
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
    const glm::mat3 xyzFromRgb(relativeXyzFromRgb());
    const float largest = std::pow(distance(huntLab(xyzFromRgb[1]), huntLab(xyzFromRgb[2])), kColourExponent);
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
    Plane edge = featureStrength(filterRows(opponent.luminance, filters.edge), blurredRows, filters.gaussian,
                                 filters.edge);
    Plane point = featureStrength(filterRows(opponent.luminance, filters.point), blurredRows, filters.gaussian,
                                  filters.point);
    toHuntLab(opponent, filters);
    return {std::move(opponent.luminance), std::move(opponent.redGreen), std::move(opponent.blueYellow),
            std::move(edge), std::move(point)};
}

Plane flipDifference(const Perceived& test, const Perceived& reference) {
    static const ColourRange range = colourRange();
    static_assert(kFeatureExponent == 0.5f);
    const float perFeature = std::sqrt(0.5f);
    Plane result(test.lightness.width, test.lightness.height);
    for (size_t i = 0; i < result.values.size(); ++i) {
        const HuntLab p{test.lightness.values[i], test.a.values[i], test.b.values[i]};
        const HuntLab q{reference.lightness.values[i], reference.a.values[i], reference.b.values[i]};
        const float colour = toUnitRange(std::pow(distance(p, q), kColourExponent), range);
        const float edge = std::abs(test.edge.values[i] - reference.edge.values[i]);
        const float point = std::abs(test.point.values[i] - reference.point.values[i]);
        const float feature = std::sqrt(perFeature * std::max(edge, point));
        result.values[i] = std::pow(colour, 1.0f - feature);
    }
    return result;
}

}  // namespace manylight
