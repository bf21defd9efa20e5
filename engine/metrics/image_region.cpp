#include "engine/metrics/image_region.h"

#include "engine/core/error.h"

#include <algorithm>
#include <charconv>

namespace manylight {

Region regionFrom(const std::string& text) {
    uint32_t numbers[4] = {};
    const char* next = text.data();
    const char* const end = text.data() + text.size();
    bool isWellFormed = true;
    for (int i = 0; i < 4; ++i) {
        const std::from_chars_result read = std::from_chars(next, end, numbers[i]);
        isWellFormed = isWellFormed && read.ec == std::errc() && (i == 3 ? read.ptr == end : read.ptr != end);
        isWellFormed = isWellFormed && (i == 3 || *read.ptr == ',');
        if (!isWellFormed) failUsage("region \"{}\": expected x,y,width,height in pixels", text);
        next = read.ptr + 1;
    }
    const Region region{numbers[0], numbers[1], numbers[2], numbers[3]};
    if (region.width == 0 || region.height == 0) failUsage("region \"{}\": expected at least one pixel", text);
    return region;
}

Image cut(const Image& image, const Region& region, const std::string& nameForErrors) {
    if (uint64_t{region.x} + region.width > image.width || uint64_t{region.y} + region.height > image.height)
        fail("{}: region {},{},{},{} does not lie inside its {} x {} pixels", nameForErrors, region.x, region.y,
             region.width, region.height, image.width, image.height);
    Image part(region.width, region.height, image.channels);
    const size_t rowTexels = size_t{region.width} * image.channels;
    for (uint32_t y = 0; y < region.height; ++y) {
        const size_t source = (size_t{region.y + y} * image.width + region.x) * image.channels;
        std::copy_n(&image.texels[source], rowTexels, &part.texels[y * rowTexels]);
    }
    return part;
}

Mask maskFrom(const Image& image) {
    Mask mask{image.width, image.height, std::vector<uint8_t>(size_t{image.width} * image.height)};
    for (size_t i = 0; i < image.texels.size(); ++i)
        if (image.texels[i] != 0.0f) mask.uses[i / image.channels] = 1;
    return mask;
}

}  // namespace manylight
