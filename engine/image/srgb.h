// The sRGB transfer curve (IEC 61966-2-1), both ways, for values in [0, 1].
#pragma once

#include <cmath>

namespace manylight {

/// Display-linear value to its sRGB code value, both in [0, 1].
inline float encodeSrgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// sRGB code value to its display-linear value, both in [0, 1].
inline float decodeSrgb(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace manylight
