// Pictures to compare, the same in tests/crosscheck/flip_figures.py: integers, powers of two and single roundings.
#pragma once

#include "engine/image/image.h"

#include <cmath>
#include <stdexcept>

namespace manylight::test {

/// A hash of integers, to [0, 1).
inline double hashedUnit(uint32_t x, uint32_t y, uint32_t channel, uint32_t seed) {
    uint32_t value = x * 0x8da6b343u ^ y * 0xd8163841u ^ channel * 0xcb1ab31fu ^ seed * 0x9e3779b9u;
    value ^= value >> 16;
    value *= 0x7feb352du;
    value ^= value >> 15;
    value *= 0x846ca68bu;
    value ^= value >> 16;
    return std::ldexp(static_cast<double>(value >> 8), -24);
}

template <typename Value>
Image pictureOf(uint32_t width, uint32_t height, const Value& value) {
    Image image(width, height, 3);
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            for (uint32_t c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(value(x, y, c));
    return image;
}

/// Blocks of 8 x 8 pixels over ten stops, with noise.
inline double noiseReference(uint32_t x, uint32_t y, uint32_t c) {
    const int level = static_cast<int>(hashedUnit(x / 8, y / 8, 0, 1) * 10.0 - 6.0);
    return std::ldexp(0.25 + 0.75 * hashedUnit(x, y, c, 2), level);
}
inline double noiseTest(uint32_t x, uint32_t y, uint32_t c) {
    return noiseReference(x, y, c) * (0.5 + hashedUnit(x, y, c, 3));
}

/// Smooth in three colours; half of the test is brighter, the other half of other colours.
inline double gradientReference(uint32_t x, uint32_t y, uint32_t c) {
    if (c == 0) return 8.0 * (x + 0.5) / 97.0;
    if (c == 1) return 2.0 * (y + 0.5) / 61.0;
    return (x + y + 1.0) / (4.0 * 158.0);
}
inline double gradientTest(uint32_t x, uint32_t y, uint32_t c) {
    return x > 48 ? gradientReference(x, y, 2 - c) : 1.125 * gradientReference(x, y, c);
}

/// Bright squares on black, the larger part; the test is shifted by a pixel and has bright single pixels.
inline double stepsReference(uint32_t x, uint32_t y, uint32_t c) {
    constexpr double kBright[] = {4.0, 1.0, 0.125};
    return (x / 16 + y / 16) % 3 == 0 ? kBright[c] : 0.0;
}
inline double stepsTest(uint32_t x, uint32_t y, uint32_t c) {
    return stepsReference(x + 1, y, c) + (hashedUnit(x, y, 0, 4) < 1.0 / 256.0 ? 64.0 : 0.0);
}

struct PicturePair {
    Image test;
    Image reference;
};

/// "noise", "gradient" or "steps", every value multiplied by `scale`.
inline PicturePair flipPictures(const std::string& name, double scale = 1.0) {
    const auto pair = [&](uint32_t width, uint32_t height, const auto& test, const auto& reference) {
        const auto scaled = [&](const auto& value) {
            return [&](uint32_t x, uint32_t y, uint32_t c) { return scale * value(x, y, c); };
        };
        return PicturePair{pictureOf(width, height, scaled(test)), pictureOf(width, height, scaled(reference))};
    };
    if (name == "noise") return pair(64, 48, noiseTest, noiseReference);
    if (name == "gradient") return pair(97, 61, gradientTest, gradientReference);
    if (name == "steps") return pair(97, 61, stepsTest, stepsReference);
    throw std::invalid_argument(name);
}

}  // namespace manylight::test
