// Smaller versions of textures (Williams1983): each half as wide and high as the one before.
#pragma once

#include "engine/scene/scene.h"

namespace manylight {

/// How texels are averaged. Colours are averaged in linear light; seen where they are opaque, by their opacity. Normals
/// are averaged as vectors, whose length nothing reads.
enum class Averaging : uint8_t { Numbers, Colours, ColoursByOpacity };

/// Levels of a chain that starts with the texture itself and ends with a single texel.
uint32_t levelsOf(uint32_t width, uint32_t height);

/// Texels of all levels but the first.
uint64_t texelsOfReduced(uint32_t width, uint32_t height);

/// All levels but the texture itself, one behind the other, RGBA as it is. A texel is the mean over its area, which
/// need not be a whole number of the texture's. Level n + 1 is max(1, n / 2) texels wide and high, rounded down.
std::vector<uint8_t> reducedTexels(const Texture& texture, Averaging averaging);

}  // namespace manylight
