#include "engine/scene/mipmaps.h"

#include "engine/image/srgb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace manylight {
namespace {

// Fully transparent texels count so much: where there are no others their colour is still theirs.
constexpr float kLeastOpacity = 1e-3f;

/// Four numbers per texel to be averaged; where opacity is a weight, colours are multiplied by it.
struct Level {
    uint32_t width;
    uint32_t height;
    std::vector<glm::vec4> texels;
};

std::array<float, 256> decodingTable(Averaging averaging) {
    std::array<float, 256> table{};
    for (size_t i = 0; i < table.size(); ++i) {
        const float value = static_cast<float>(i) / 255.0f;
        table[i] = averaging == Averaging::Numbers ? value : decodeSrgb(value);
    }
    return table;
}

float weightOf(float alpha, Averaging averaging) {
    return averaging == Averaging::ColoursByOpacity ? std::max(alpha, kLeastOpacity) : 1.0f;
}

Level firstLevel(const Texture& texture, Averaging averaging) {
    const std::array<float, 256> decoded = decodingTable(averaging);
    Level level{texture.width, texture.height, {}};
    level.texels.reserve(texture.rgba.size() / 4);
    for (size_t i = 0; i + 3 < texture.rgba.size(); i += 4) {
        // Of what counts by opacity the weight is what is averaged, and no opacity is read that far away.
        const float weight = weightOf(static_cast<float>(texture.rgba[i + 3]) / 255.0f, averaging);
        const float alpha = averaging == Averaging::ColoursByOpacity ? weight : texture.rgba[i + 3] / 255.0f;
        level.texels.emplace_back(weight * decoded[texture.rgba[i]], weight * decoded[texture.rgba[i + 1]],
                                  weight * decoded[texture.rgba[i + 2]], alpha);
    }
    return level;
}

/// The mean over [from, to) of a row of texels, `stride` apart.
glm::vec4 meanOver(const glm::vec4* row, size_t stride, double from, double to) {
    glm::vec4 sum(0.0f);
    for (auto i = static_cast<size_t>(from); static_cast<double>(i) < to; ++i) {
        const auto at = static_cast<double>(i);
        sum += static_cast<float>(std::min(to, at + 1.0) - std::max(from, at)) * row[i * stride];
    }
    return sum / static_cast<float>(to - from);
}

/// Along one axis: `count` texels become `reduced`, in each of `lines`.
std::vector<glm::vec4> reduceAxis(const std::vector<glm::vec4>& texels, uint32_t count, size_t stride, uint32_t reduced,
                                  size_t reducedStride, uint32_t lines, size_t lineStride, size_t reducedLineStride) {
    if (count == reduced) return texels;
    std::vector<glm::vec4> result(size_t{reduced} * lines);
    const double share = static_cast<double>(count) / reduced;
    for (uint32_t line = 0; line < lines; ++line)
        for (uint32_t i = 0; i < reduced; ++i)
            result[line * reducedLineStride + i * reducedStride] =
                meanOver(&texels[line * lineStride], stride, i * share, std::min<double>((i + 1) * share, count));
    return result;
}

Level halved(const Level& level) {
    const uint32_t width = std::max(level.width / 2, 1u);
    const uint32_t height = std::max(level.height / 2, 1u);
    const std::vector<glm::vec4> narrow =
        reduceAxis(level.texels, level.width, 1, width, 1, level.height, level.width, width);
    return {width, height, reduceAxis(narrow, level.height, width, height, width, width, 1, 1)};
}

uint8_t byteOf(float value) { return static_cast<uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f))); }

void append(std::vector<uint8_t>& bytes, const Level& level, Averaging averaging) {
    for (const glm::vec4& texel : level.texels) {
        const float weight = averaging == Averaging::ColoursByOpacity ? texel.a : 1.0f;
        for (int c = 0; c < 3; ++c) {
            const float value = texel[c] / weight;
            bytes.push_back(byteOf(averaging == Averaging::Numbers ? value : encodeSrgb(value)));
        }
        bytes.push_back(byteOf(texel.a));
    }
}

}  // namespace

uint32_t levelsOf(uint32_t width, uint32_t height) {
    return static_cast<uint32_t>(std::bit_width(std::max({width, height, 1u})));
}

uint64_t texelsOfReduced(uint32_t width, uint32_t height) {
    uint64_t texels = 0;
    for (uint32_t level = 1; level < levelsOf(width, height); ++level)
        texels += uint64_t{std::max(width >> level, 1u)} * std::max(height >> level, 1u);
    return texels;
}

std::vector<uint8_t> reducedTexels(const Texture& texture, Averaging averaging) {
    std::vector<uint8_t> bytes;
    bytes.reserve(4 * texelsOfReduced(texture.width, texture.height));
    Level level = firstLevel(texture, averaging);
    while (level.width > 1 || level.height > 1) {
        level = halved(level);
        append(bytes, level, averaging);
    }
    return bytes;
}

}  // namespace manylight
