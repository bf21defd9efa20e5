#include "tests/gpu/gpu_test.h"

#include "engine/core/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <numeric>

namespace manylight::test {
namespace {

/// Gives the device, and what was compiled for it, back before the Vulkan loader goes away with the other globals.
class DeviceOfProcess : public ::testing::Environment {
  public:
    void TearDown() override {
        pipelines_.reset();
        device_.reset();
    }
    gpu::Device& device() {
        if (!device_) device_ = std::make_unique<gpu::Device>(gpu::DeviceOptions{{}, gpu::Validation::Sync});
        return *device_;
    }
    gpu::PipelineLibrary& pipelines() {
        if (!pipelines_) pipelines_ = std::make_unique<gpu::PipelineLibrary>(device());
        return *pipelines_;
    }

  private:
    std::unique_ptr<gpu::Device> device_;
    std::unique_ptr<gpu::PipelineLibrary> pipelines_;
};

DeviceOfProcess* const deviceOfProcess = [] {
    setenv("MANYLIGHT_TUNING", "off", 0);     // but for a file that is given to the tests
    auto* environment = new DeviceOfProcess;  // GoogleTest owns it
    ::testing::AddGlobalTestEnvironment(environment);
    return environment;
}();

}  // namespace

gpu::Device& device() { return deviceOfProcess->device(); }

gpu::PipelineLibrary* pipelines() { return &deviceOfProcess->pipelines(); }

RenderSettings plainSettings(uint32_t width, uint32_t height) {
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.vplCount = 0;
    settings.bounceCount = 0;
    settings.russianRoulette = false;
    settings.castShadows = false;
    settings.gbuffer = GBufferBy::Raster;  // as forward techniques do
    return settings;
}

Image render(const Scene& scene, const RenderSettings& settings, uint32_t frames) {
    Renderer renderer(device(), scene, settings, pipelines());
    for (uint32_t i = 0; i < frames; ++i) renderer.renderFrame();
    return renderer.radiance();
}

VplList renderVpls(const Scene& scene, const RenderSettings& settings) {
    Renderer renderer(device(), scene, settings, pipelines());
    renderer.keepVpls();
    renderer.renderFrame();
    return {renderer.vpls(), renderer.status()};
}

double meanOf(const Image& image) {
    return std::accumulate(image.texels.begin(), image.texels.end(), 0.0) / static_cast<double>(image.texels.size());
}

double largestOf(const Image& image) { return double{*std::max_element(image.texels.begin(), image.texels.end())}; }

bool sameBits(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && a.texels.size() == b.texels.size() &&
           std::memcmp(a.texels.data(), b.texels.data(), a.texels.size() * sizeof(float)) == 0;
}

bool sameBits(const std::vector<shared::LightData>& a, const std::vector<shared::LightData>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(shared::LightData)) == 0;
}

void forEachSeed(const Scene& scene, RenderSettings settings, uint32_t seeds, const std::function<void(Renderer&)>& use,
                 uint32_t frames) {
    Renderer renderer(device(), scene, settings, pipelines());
    renderer.keepVpls();
    for (settings.seed = 0; settings.seed < seeds; ++settings.seed) {
        renderer.restart(settings);
        for (uint32_t frame = 0; frame < frames; ++frame) renderer.renderFrame();
        use(renderer);
    }
}

void expectMean(const std::vector<double>& samples, double expected, double largestError) {
    const Estimate found = estimate(samples);
    // Rounding alone may leave an error where the samples hardly differ.
    const double error = std::max(found.error, 2e-6 * std::abs(expected));
    EXPECT_LT(error, largestError) << "the samples scatter too much to say anything; their mean is " << found.mean;
    EXPECT_LT(std::abs(found.mean - expected), 5.0 * error)
        << "mean " << found.mean << " +- " << error << ", expected " << expected;
}

}  // namespace manylight::test
