// Parts of a picture: a rectangle, and a mask of single pixels.
#pragma once

#include "engine/image/image.h"

#include <string>

namespace manylight {

/// A rectangle of pixels; (x, y) is its upper left one.
struct Region {
    uint32_t x = 0;
    uint32_t y = 0;
    uint32_t width = 0;
    uint32_t height = 0;
};

/// Reads "x,y,w,h". Throws Error (usage) for anything else, or an empty rectangle.
Region regionFrom(const std::string& text);

/// The rectangle as a picture of its own. Throws Error naming `nameForErrors` and its size if it does not contain it.
Image cut(const Image& image, const Region& region, const std::string& nameForErrors);

/// The pixels that count: one byte each, 1 or 0, row 0 at the top.
struct Mask {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> uses;
};

/// A pixel counts if any of its channels is not zero.
Mask maskFrom(const Image& image);

}  // namespace manylight
