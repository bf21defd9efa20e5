// Which pixels of a pair of pictures a metric looks at, and how many it had to leave out.
#pragma once

#include "engine/metrics/image_region.h"

namespace manylight {

/// Whether no channel of the pixel is an infinity or NaN, told by the exponent's bits.
bool isFinitePixel(const Image& image, size_t pixel);

/// `uses` has one byte for each pixel, 1 where both pictures are finite and the mask has it.
struct PixelUse {
    std::vector<uint8_t> uses;
    uint64_t compared = 0;            // ones in `uses`
    uint64_t maskedOut = 0;           // left out because the mask is zero there
    uint64_t nonFinite = 0;           // left out because a channel of either picture is not finite
    uint64_t nonFiniteTest = 0;       // of these: in the test picture
    uint64_t nonFiniteReference = 0;  // of these: in the reference; a pixel may be in both
};

/// Pictures and mask must have one size. No mask: every pixel.
PixelUse pixelUse(const Image& test, const Image& reference, const Mask* mask = nullptr);

}  // namespace manylight
