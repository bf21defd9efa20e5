// Sums over many frames lose nothing, and their variance is what the frames' scatter says.
#include "engine/core/report.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace manylight::test {
namespace {

using AccumulatorTest = GpuTest;

TEST_F(AccumulatorTest, ManyFramesAreSummedAsExactlyAsOne) {
    constexpr uint32_t kFrames = 2000;
    Scene scene = closedBox(glm::vec3(0.5f));
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(0.3f, 0.7f, 0.011f)));
    const RenderSettings settings = plainSettings(1, 1);  // nothing random: all frames are the same
    const Image one = render(scene, settings);
    const Image many = render(scene, settings, kFrames);
    double worstOfPlainSums = 0.0;
    for (size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(many.texels[c] / one.texels[c], 1.0f, 2.5e-7f) << c;
        float plain = 0.0f;
        for (uint32_t frame = 0; frame < kFrames; ++frame) plain += one.texels[c];
        worstOfPlainSums = std::max(worstOfPlainSums, std::abs(double{plain} / kFrames / double{one.texels[c]} - 1.0));
    }
    EXPECT_GT(worstOfPlainSums, 2e-6) << "a plain sum would have passed";
}

RenderSettings noisySettings() {
    RenderSettings settings = plainSettings(12, 9);
    settings.technique = Technique::PathTracer;
    settings.castShadows = true;
    settings.bounceCount = 2;
    return settings;
}

TEST_F(AccumulatorTest, TheVarianceIsThatOfFramesOfOtherSeeds) {
    constexpr uint32_t kFrames = 32;
    const Scene scene = closedBox(glm::vec3(0.5f), {1.0f, 2.0f, 0.5f});
    // The variance of a single frame, over seeds.
    std::vector<double> sums(12 * 9 * 3);
    std::vector<double> squares(sums.size());
    constexpr uint32_t kSeeds = 300;
    forEachSeed(scene, noisySettings(), kSeeds, [&](Renderer& renderer) {
        const Image image = renderer.radiance();
        for (size_t i = 0; i < sums.size(); ++i) {
            sums[i] += double{image.texels[i]};
            squares[i] += double{image.texels[i]} * double{image.texels[i]};
        }
    });
    double expected = 0.0;
    for (size_t i = 0; i < sums.size(); ++i)
        expected += (squares[i] - sums[i] * sums[i] / kSeeds) / (kSeeds - 1.0) / static_cast<double>(sums.size());

    double found = 0.0;
    constexpr uint32_t kRuns = 8;
    RenderSettings settings = noisySettings();
    Renderer renderer(device(), scene, settings, pipelines());
    renderer.keepVariance(true);
    for (uint32_t run = 0; run < kRuns; ++run) {
        settings.seed = 1000 + run;
        renderer.restart(settings);
        for (uint32_t frame = 0; frame < kFrames; ++frame) renderer.renderFrame();
        found += meanOf(renderer.varianceOfMean()) * kFrames / kRuns;
        const double relative = std::sqrt(meanOf(renderer.varianceOfMean())) / meanOf(renderer.radiance());
        EXPECT_NEAR(renderer.relativeStandardError(), relative, 1e-6 * relative);
    }
    // Stratified frames scatter more within a run than independent ones, by at most 1 / (frames - 1); the rest is the
    // error of variances from 108 pixels and as many runs.
    EXPECT_GT(found, 0.95 * expected);
    EXPECT_LT(found, (1.0 + 1.0 / (kFrames - 1.0) + 0.05) * expected);
}

TEST_F(AccumulatorTest, TheErrorFallsWithTheSquareRootOfFrames) {
    const Scene scene = closedBox(glm::vec3(0.5f), glm::vec3(1.0f));
    Renderer renderer(device(), scene, noisySettings(), pipelines());
    renderer.keepVariance(true);
    for (int frame = 0; frame < 16; ++frame) renderer.renderFrame();
    const double before = renderer.relativeStandardError();
    for (int frame = 16; frame < 256; ++frame) renderer.renderFrame();
    EXPECT_NEAR(renderer.relativeStandardError() / before, 0.25, 0.03);
}

TEST_F(AccumulatorTest, ACaptureEndsWhereItsErrorIsTheTarget) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "manylight_target_error_test";
    std::filesystem::create_directories(folder);
    const std::string report = (folder / "report.json").string();
    const std::string command =
        std::string("'") + MANYLIGHT_BINARY_DIR + "/bin/manylight-capture' '" + MANYLIGHT_SOURCE_DIR +
        "/scenes/cornell_box.json' -o '" + (folder / "picture.exr").string() +
        "' --size 24x18 --technique path-tracer --target-error 0.4 --report '" + report + "' > /dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const Json json = Json::parse(std::ifstream(report));
    std::filesystem::remove_all(folder);
    EXPECT_EQ(json.at("ended_by"), "error");
    EXPECT_GT(json.at("frames").get<int>(), 8);
    // It looks again after an eighth more frames at the latest.
    EXPECT_LE(json.at("relative_standard_error").get<double>(), 0.4);
    EXPECT_GT(json.at("relative_standard_error").get<double>(), 0.3);
}

TEST_F(AccumulatorTest, NothingRandomHasNoVariance) {
    Scene scene = closedBox(glm::vec3(0.5f));
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(0.3f)));
    Renderer renderer(device(), scene, plainSettings(), pipelines());
    renderer.keepVariance(true);
    for (int frame = 0; frame < 4; ++frame) renderer.renderFrame();
    // The mean is that of 1, 2 and 3 frames, to rounding.
    EXPECT_LT(renderer.relativeStandardError(), 1e-7);
}

}  // namespace
}  // namespace manylight::test
