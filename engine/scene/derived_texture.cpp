#include "engine/scene/derived_texture.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

/// The texel before the first or past the last.
uint32_t wrapped(int64_t i, uint32_t size, TextureWrap wrap) {
    if (i >= 0 && i < size) return static_cast<uint32_t>(i);
    if (wrap == TextureWrap::Repeat) return i < 0 ? size - 1 : 0;
    return i < 0 ? 0 : size - 1;  // clamped, and at the edge of a mirror
}

uint8_t encoded(double component) { return static_cast<uint8_t>(std::lround((component * 0.5 + 0.5) * 255.0)); }

}  // namespace

std::vector<float> channelOf(const EncodedImage& image, char channel) {
    // Rec. 709's luminance of the stored numbers: height and coverage are no colours.
    const glm::vec4 weights = channel == 'r'   ? glm::vec4(1, 0, 0, 0)
                              : channel == 'g' ? glm::vec4(0, 1, 0, 0)
                              : channel == 'b' ? glm::vec4(0, 0, 1, 0)
                              : channel == 'm' ? glm::vec4(0, 0, 0, 1)
                                               : glm::vec4(0.2126f, 0.7152f, 0.0722f, 0);
    std::vector<float> values(size_t{image.width} * image.height);
    for (size_t i = 0; i < values.size(); ++i) {
        const uint8_t* const texel = image.rgba.data() + 4 * i;
        values[i] = glm::dot(weights, glm::vec4(texel[0], texel[1], texel[2], texel[3]));
    }
    return values;
}

bool hasAlpha(const EncodedImage& image) {
    for (size_t i = 3; i < image.rgba.size(); i += 4)
        if (image.rgba[i] != 255) return true;
    return false;
}

EncodedImage coverageImage(const EncodedImage& image, char channel) {
    const std::vector<float> coverage = channelOf(image, channel);
    EncodedImage result{image.width, image.height, std::vector<uint8_t>(image.rgba.size(), 255)};
    for (size_t i = 0; i < coverage.size(); ++i)
        result.rgba[4 * i + 3] = static_cast<uint8_t>(std::lround(coverage[i]));
    return result;
}

bool isCutout(const EncodedImage& image) {
    constexpr uint8_t kNearlyNothing = 25;
    constexpr uint8_t kNearlyAll = 230;
    size_t between = 0;
    bool hasHole = false;
    for (size_t i = 3; i < image.rgba.size(); i += 4) {
        const uint8_t alpha = image.rgba[i];
        hasHole = hasHole || alpha <= kNearlyNothing;
        if (alpha > kNearlyNothing && alpha < kNearlyAll) ++between;
    }
    return hasHole && 10 * between <= image.rgba.size() / 4;
}

bool looksLikeNormals(const EncodedImage& image) {
    double sums[3] = {};
    for (size_t i = 0; i < image.rgba.size(); i += 4)
        for (size_t channel = 0; channel < 3; ++channel) sums[channel] += image.rgba[i + channel];
    const double scale = 1.0 / (255.0 * std::max<double>(1.0, static_cast<double>(image.rgba.size() / 4)));
    const auto isNearHalf = [&](double sum) { return std::abs(sum * scale - 0.5) < 0.1; };
    return isNearHalf(sums[0]) && isNearHalf(sums[1]) && sums[2] * scale > 0.75;
}

EncodedImage normalsOfHeights(const EncodedImage& image, char channel, double whiteHeight, const Texture& sampling) {
    const std::vector<float> heights = channelOf(image, channel);
    const auto heightAt = [&](int64_t x, int64_t y) {
        const size_t row = wrapped(y, image.height, sampling.wrapV);
        return double{heights[row * image.width + wrapped(x, image.width, sampling.wrapU)]};
    };
    const double slopePerStep = 0.5 * whiteHeight / 255.0;
    EncodedImage result{image.width, image.height, std::vector<uint8_t>(image.rgba.size(), 255)};
    for (int64_t y = 0; y < image.height; ++y)
        for (int64_t x = 0; x < image.width; ++x) {
            // Rows grow downwards: up is towards the row before.
            const glm::dvec3 normal =
                glm::normalize(glm::dvec3(slopePerStep * (heightAt(x - 1, y) - heightAt(x + 1, y)),
                                          slopePerStep * (heightAt(x, y + 1) - heightAt(x, y - 1)), 1.0));
            uint8_t* const texel =
                result.rgba.data() + 4 * (static_cast<size_t>(y) * image.width + static_cast<size_t>(x));
            for (int c = 0; c < 3; ++c) texel[c] = encoded(normal[c]);
        }
    return result;
}

}  // namespace manylight
