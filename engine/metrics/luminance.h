// Relative luminance of linear RGB with the primaries of BT.709 and sRGB.
#pragma once

namespace manylight {

/// `rgb` points to three linear values.
inline double luminanceOf(const float* rgb) {
    return 0.2126 * double{rgb[0]} + 0.7152 * double{rgb[1]} + 0.0722 * double{rgb[2]};
}

}  // namespace manylight
