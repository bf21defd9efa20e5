// What suits a device shows in no picture: every value of every tunable gives the same bytes.
#include "engine/core/file.h"
#include "engine/gpu/tuning_file.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/instanced_scenes.h"

#include <algorithm>
#include <cstdlib>

namespace manylight::test {
namespace {

using TuningTest = GpuTest;

/// The number `index` of values of every tunable, or the last; as far as a small device can run it.
gpu::Tuning tuningOfValues(size_t index) {
    gpu::Tuning tuning;
    for (const gpu::Tunable& tunable : gpu::tunables()) {
        gpu::Tuning other = tuning;
        tunable.of(other) = tunable.values[std::min(index, tunable.values.size() - 1)];
        if (gpu::fits(other, gpu::groupLimits(device()))) tuning = other;
    }
    return tuning;
}

void expectSameBytes(const Scene& scene, const RenderSettings& settings, const std::vector<size_t>& indices,
                     uint32_t frames = 2) {
    Renderer renderer(device(), scene, settings);
    const auto picture = [&](const gpu::Tuning& tuning) {
        renderer.setTuning(tuning);
        renderer.forgetHistory();
        renderer.restart(settings);
        for (uint32_t i = 0; i < frames; ++i) renderer.renderFrame();
        return renderer.radiance();
    };
    const Image usual = picture({});
    EXPECT_GT(largestOf(usual), 0.0);
    for (const size_t index : indices) {
        const gpu::Tuning tuning = tuningOfValues(index);
        EXPECT_NE(tuning, gpu::Tuning{});
        EXPECT_TRUE(sameBits(picture(tuning), usual)) << gpu::toJson(tuning).dump();
    }
}

/// No multiple of any tile.
RenderSettings globalSettings(uint32_t width = 45, uint32_t height = 35) {
    RenderSettings settings = plainSettings(width, height);
    settings.vplCount = 150;
    settings.bounceCount = 4;
    settings.castShadows = true;
    return settings;
}

TEST_F(TuningTest, WithoutRays) {
    RenderSettings settings = globalSettings();
    settings.temporal = true;
    settings.castShadows = false;
    expectSameBytes(sphereInBox(), settings, {1, 2});
}

/// MANYLIGHT_TUNING for as long as it lives.
class TuningVariable {
  public:
    explicit TuningVariable(const std::filesystem::path& file) { setenv("MANYLIGHT_TUNING", file.c_str(), 1); }
    ~TuningVariable() { setenv("MANYLIGHT_TUNING", before_.c_str(), 1); }
    TuningVariable(const TuningVariable&) = delete;
    TuningVariable& operator=(const TuningVariable&) = delete;

  private:
    const std::string before_ = std::getenv("MANYLIGHT_TUNING");
};

TEST_F(TuningTest, ARendererTakesWhatTheFileHasForItsDevice) {
    const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "manylight_tuning_of_device.json";
    const Scene scene = sphereInBox();
    EXPECT_EQ(Renderer(device(), scene, plainSettings()).tuning(), gpu::Tuning{});
    gpu::writeTuning(file, gpu::tuningKey(device()), tuningOfValues(2));
    {
        const TuningVariable variable(file);
        const Renderer renderer(device(), scene, plainSettings());
        EXPECT_EQ(renderer.tuning(), tuningOfValues(2));
        EXPECT_TRUE(renderer.warnings().empty());
        writeTextFile(file, "{");
        const Renderer other(device(), scene, plainSettings());
        EXPECT_EQ(other.tuning(), gpu::Tuning{});
        EXPECT_EQ(other.warnings().total(), 1u);
    }
    std::filesystem::remove(file);
}

TEST_F(TuningTest, ShadowRaysOfInstances) {
    RenderSettings settings = globalSettings();
    settings.gbuffer = GBufferBy::Rays;
    expectSameBytes(roomOfInstances(), settings, {1});
}

TEST_F(TuningTest, ADispatchInParts) {
    RenderSettings settings = globalSettings(120, 70);
    settings.vplCount = 256;
    // 16 parts of 2^24 rays are less than the picture's.
    expectSameBytes(sphereInBox(), settings, {2}, 1);
}

TEST_F(TuningTest, ResampledAndFiltered) {
    RenderSettings settings = globalSettings();
    applySetting(settings, "quality", "draft");
    settings.vplCount = 640;
    settings.gatherStep = 2;
    expectSameBytes(glossyRoom(), settings, {3});
}

TEST_F(TuningTest, Compensated) {
    RenderSettings settings = globalSettings();
    settings.clamp = ClampMode::Compensate;
    settings.clampBound = 3.0f;
    expectSameBytes(translucentRoom(), settings, {4});
}

TEST_F(TuningTest, Forward) {
    RenderSettings settings = globalSettings();
    settings.technique = Technique::ForwardPrepass;
    expectSameBytes(sphereInBox(), settings, {3});
}

TEST_F(TuningTest, PathTraced) {
    RenderSettings settings = globalSettings();
    settings.technique = Technique::PathTracer;
    settings.jitter = true;
    expectSameBytes(roomOfInstances(), settings, {4});
}

}  // namespace
}  // namespace manylight::test
