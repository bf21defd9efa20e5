#include "tests/gpu/z_test.h"

#include "engine/core/check.h"
#include "engine/core/statistics.h"
#include "tests/support/significance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace manylight::test {
namespace {

constexpr size_t kColumns = 4;
constexpr size_t kRows = 3;
constexpr size_t kBlocks = kColumns * kRows * 3;
constexpr double kSignificance = 0.001;

std::vector<double> blockMeans(const Image& image) {
    MANYLIGHT_CHECK(image.width % kColumns == 0u, "{}x{}", image.width, image.height);
    MANYLIGHT_CHECK(image.height % kRows == 0u, "{}x{}", image.width, image.height);
    const size_t width = image.width / kColumns;
    const size_t height = image.height / kRows;
    std::vector<double> means(kBlocks);
    for (size_t i = 0; i < image.texels.size(); ++i) {
        const size_t x = i / 3 % image.width;
        const size_t y = i / 3 / image.width;
        means[(y / height * kColumns + x / width) * 3 + i % 3] +=
            double{image.texels[i]} / static_cast<double>(width * height);
    }
    return means;
}

}  // namespace

PictureSamples samplePictures(const Scene& scene, RenderSettings settings, Seeds seeds) {
    Renderer renderer(device(), scene, settings, pipelines());
    PictureSamples samples;
    samples.blocks.resize(kBlocks);
    for (uint32_t seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
        settings.seed = seed;
        renderer.restart(settings);
        for (uint32_t frame = 0; frame < seeds.frames; ++frame) renderer.renderFrame();
        const Image image = renderer.radiance();
        samples.mean.push_back(meanOf(image));
        const std::vector<double> means = blockMeans(image);
        for (size_t block = 0; block < kBlocks; ++block) samples.blocks[block].push_back(means[block]);
    }
    return samples;
}

bool toldApart(const PictureSamples& a, const PictureSamples& b) {
    double least = welchPValue(a.mean, b.mean);
    for (size_t block = 0; block < kBlocks; ++block)
        least = std::min(least, welchPValue(a.blocks[block], b.blocks[block]));
    return least <= sidak(kSignificance, kBlocks + 1);
}

void expectSameMeans(const PictureSamples& a, const PictureSamples& b, double largestError) {
    const Estimate ofA = estimate(a.mean);
    const Estimate ofB = estimate(b.mean);
    const std::string means = fmt::format("{} +- {} and {} +- {}", ofA.mean, ofA.error, ofB.mean, ofB.error);
    EXPECT_LT(std::hypot(ofA.error, ofB.error), largestError * ofB.mean)
        << "the samples scatter too much to say anything: " << means;
    const double significance = sidak(kSignificance, kBlocks + 1);
    EXPECT_GT(welchPValue(a.mean, b.mean), significance) << "the whole picture: " << means;
    for (size_t block = 0; block < kBlocks; ++block) {
        const Estimate inA = estimate(a.blocks[block]);
        const Estimate inB = estimate(b.blocks[block]);
        EXPECT_GT(welchPValue(a.blocks[block], b.blocks[block]), significance)
            << "channel " << block % 3 << " of block " << block / 3 % kColumns << ", " << block / 3 / kColumns << ": "
            << inA.mean << " +- " << inA.error << " and " << inB.mean << " +- " << inB.error;
    }
}

PictureSamples scaled(PictureSamples samples, double factor) {
    for (double& sample : samples.mean) sample *= factor;
    for (std::vector<double>& block : samples.blocks)
        for (double& sample : block) sample *= factor;
    return samples;
}

}  // namespace manylight::test
