// Estimators against each other, by the means of their pictures over independent seeds. Never over the pixels of one
// picture: all of them gather from the same VPLs.
#pragma once

#include "tests/gpu/gpu_test.h"

namespace manylight::test {

/// One number from each seed, for the whole picture and for each of its blocks.
struct PictureSamples {
    std::vector<double> mean;                 // of all pixels and channels
    std::vector<std::vector<double>> blocks;  // 4 x 3 blocks by 3 channels
};

struct Seeds {
    uint32_t first = 0;
    uint32_t count = 16;
    uint32_t frames = 1;  // of each
};

/// The picture's width and height are multiples of 4 and 3.
PictureSamples samplePictures(const Scene& scene, RenderSettings settings, Seeds seeds);

/// Fails if Welch's test tells the two apart, in any block or in the whole, with a chance of 0.001 for all of them
/// together to do so without a cause; or if the standard error of the difference of the means is more than
/// `largestError` of the mean: then the test would say little.
void expectSameMeans(const PictureSamples& a, const PictureSamples& b, double largestError);

/// Whether Welch's test tells them apart, at that significance.
bool toldApart(const PictureSamples& a, const PictureSamples& b);

/// As if the estimator had made everything brighter.
PictureSamples scaled(PictureSamples samples, double factor);

}  // namespace manylight::test
