// A float image of one to four channels, row 0 at the top.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace manylight {

struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t channels = 3;
    std::vector<float> texels;  // height * width * channels, interleaved

    Image() = default;
    Image(uint32_t w, uint32_t h, uint32_t c) : width(w), height(h), channels(c), texels(size_t{w} * h * c) {}
    float& at(uint32_t x, uint32_t y, uint32_t c) { return texels[(size_t{y} * width + x) * channels + c]; }
    float at(uint32_t x, uint32_t y, uint32_t c) const { return texels[(size_t{y} * width + x) * channels + c]; }
};

}  // namespace manylight
