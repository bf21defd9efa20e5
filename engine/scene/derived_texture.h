// Textures made of others: coverage in the alpha channel, normals of a height field.
#pragma once

#include "engine/image/image_io.h"
#include "engine/scene/scene.h"

namespace manylight {

/// One channel of an image as numbers in [0, 255], row by row: 'r', 'g', 'b', 'm' (alpha) or 'l' (luminance).
std::vector<float> channelOf(const EncodedImage& image, char channel);

/// Is any texel's alpha below 255?
bool hasAlpha(const EncodedImage& image);

/// White texels whose alpha is a channel of the image.
EncodedImage coverageImage(const EncodedImage& image, char channel);

/// Are at most a tenth of the alphas neither nearly 0 nor nearly 255, and some of them nearly 0?
bool isCutout(const EncodedImage& image);

/// Is the mean colour that of a map of normals around (0, 0, 1), encoded as (n + 1) / 2?
bool looksLikeNormals(const EncodedImage& image);

/// Normals of a height field by central differences, encoded as (n + 1) / 2 with green towards the first row.
/// `whiteHeight`: of white above black, in texels. The field goes on beyond its edges as `sampling` says.
EncodedImage normalsOfHeights(const EncodedImage& image, char channel, double whiteHeight, const Texture& sampling);

}  // namespace manylight
