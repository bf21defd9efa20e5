// The colour arithmetic of FLIP. In a header, and in plain floats without a union: loops over pixels shall vectorise.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace manylight::perception {

struct Triple {
    float x, y, z;
};

struct Matrix {
    Triple rows[3];
    Triple operator*(const Triple& v) const {
        return {rows[0].x * v.x + rows[0].y * v.y + rows[0].z * v.z,
                rows[1].x * v.x + rows[1].y * v.y + rows[1].z * v.z,
                rows[2].x * v.x + rows[2].y * v.y + rows[2].z * v.z};
    }
};

struct ColourSpace {
    Matrix xyzFromRgb;  // linear RGB with sRGB's primaries to XYZ over the XYZ of white: each row sums to 1
    Matrix rgbFromXyz;
};

const ColourSpace& colourSpace();

/// Cube root of a value in [0.001, 2], to float precision: a guess from the exponent and two of Halley's steps. The
/// library's function does not vectorise.
inline float cubeRoot(float value) {
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
inline float compress(float value) {
    constexpr float kDelta = 6.0f / 29.0f;
    constexpr float kThreshold = kDelta * kDelta * kDelta;
    const float line = value / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
    const float root = cubeRoot(std::max(value, kThreshold));
    return value > kThreshold ? root : line;
}

/// Lightness, a and b.
struct HuntLab {
    float lightness;
    float a;
    float b;
};

/// `xyz` relative to white. The chroma shrinks with the lightness, as Hunt's effect has it.
inline HuntLab huntLab(const Triple& xyz) {
    const float x = compress(xyz.x);
    const float y = compress(xyz.y);
    const float z = compress(xyz.z);
    const float lightness = 116.0f * y - 16.0f;
    const float scale = 0.01f * lightness;
    return {lightness, scale * 500.0f * (x - y), scale * 200.0f * (y - z)};
}

/// HyAB: city block in lightness, Euclidean in chroma.
inline float colourDistance(const HuntLab& p, const HuntLab& q) {
    const float a = p.a - q.a;
    const float b = p.b - q.b;
    return std::abs(p.lightness - q.lightness) + std::sqrt(a * a + b * b);
}

}  // namespace manylight::perception
