// What the tests on the device share: one device per process, validated to the last barrier, and short ways to render.
#pragma once

#include "engine/gpu/device.h"
#include "engine/techniques/renderer.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace manylight::test {

/// The one device of the process, with synchronisation validation. Without a device this throws: a failure, no skip.
gpu::Device& device();

/// What the renderers of a process share: a shader is compiled once for all tests of a suite that use it alike.
gpu::PipelineLibrary* pipelines();

/// Every test ends with as many validation messages as it began with.
class GpuTest : public ::testing::Test {
  protected:
    void SetUp() override { messagesBefore_ = device().instance().validationMessages(); }
    void TearDown() override {
        EXPECT_EQ(device().instance().validationMessages(), messagesBefore_) << "see standard error";
    }

  private:
    uint64_t messagesBefore_ = 0;
};

/// No shadows, no Russian roulette, no bounces, a small picture: tests switch on what they are about.
RenderSettings plainSettings(uint32_t width = 32, uint32_t height = 24);

/// Mean radiance of `frames` frames.
Image render(const Scene& scene, const RenderSettings& settings, uint32_t frames = 1);

/// The VPL list of the first frame, with the counters of that frame.
struct VplList {
    std::vector<shared::LightData> vpls;
    shared::FrameStatus status{};
};
VplList renderVpls(const Scene& scene, const RenderSettings& settings);

double meanOf(const Image& image);
double largestOf(const Image& image);
bool sameBits(const Image& a, const Image& b);
bool sameBits(const std::vector<shared::LightData>& a, const std::vector<shared::LightData>& b);

/// Renders `seeds` pictures of `frames` frames with seeds 0, 1, ... and calls `use` with each: one renderer, one scene.
void forEachSeed(const Scene& scene, RenderSettings settings, uint32_t seeds, const std::function<void(Renderer&)>& use,
                 uint32_t frames = 1);

/// Fails if the mean of independent samples is further than 5 standard errors from `expected`, which chance does once
/// in 6,000 times with 16 samples; or if the standard error is above `largestError`: then the test would say nothing.
void expectMean(const std::vector<double>& samples, double expected, double largestError);

}  // namespace manylight::test
