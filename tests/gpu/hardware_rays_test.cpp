// Rays by the device, VK_KHR_ray_query, against those by shaders: the same pictures but for rays that pass within
// rounding of an edge. Where the device has none, these tests say so and are passed over, or fail if it was expected
// to: MANYLIGHT_EXPECT_RAY_QUERY=1.
#include "engine/core/error.h"
#include "engine/techniques/ray_caster.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/instanced_scenes.h"
#include "tests/unit/bvh_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

namespace manylight::test {
namespace {

class HardwareRays : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (device().canTraceRays()) return;
        const std::string lacks = "device " + device().info().name + " lacks " + device().missingForRays();
        const char* expected = std::getenv("MANYLIGHT_EXPECT_RAY_QUERY");
        ASSERT_FALSE(expected != nullptr && std::string_view(expected) == "1") << lacks;
        GTEST_SKIP() << "hardware rays are not tested: " << lacks;
    }
};

RenderSettings shadowedSettings(Technique technique) {
    RenderSettings settings = plainSettings(64, 48);
    settings.technique = technique;
    settings.castShadows = true;
    settings.vplCount = 48;
    settings.bounceCount = 3;
    return settings;
}

Image renderBy(RaysBy rays, const Scene& scene, RenderSettings settings) {
    settings.rays = rays;
    return render(scene, settings);
}

/// Share of pixels with a channel that differs by more than a thousandth of the mean.
double shareOfOtherPixels(const Image& a, const Image& b) {
    const double tolerance = 1e-3 * meanOf(a);
    size_t others = 0;
    for (size_t pixel = 0; pixel < a.texels.size(); pixel += a.channels) {
        bool isOther = false;
        for (size_t i = pixel; i < pixel + a.channels; ++i)
            isOther = isOther || std::abs(double{a.texels[i]} - double{b.texels[i]}) > tolerance;
        others += isOther ? 1 : 0;
    }
    return static_cast<double>(others) / (static_cast<double>(a.width) * a.height);
}

/// The two ways round a ray's place differently, by about 2^-22 of the scene's size. That is a 10,000th of a pixel's
/// width at most, and a pixel has up to 200 rays: of these, one in 50 may have the other answer at an edge in the worst
/// case, were there an edge in every pixel. Few have one, so one pixel in 100 is ample.
void expectSamePicture(const Scene& scene, const RenderSettings& settings) {
    SCOPED_TRACE(name(settings.technique));
    const Image software = renderBy(RaysBy::Software, scene, settings);
    const Image hardware = renderBy(RaysBy::Hardware, scene, settings);
    ASSERT_EQ(software.texels.size(), hardware.texels.size());
    EXPECT_GT(meanOf(software), 0.0);
    EXPECT_LE(shareOfOtherPixels(software, hardware), 0.01);
    EXPECT_NEAR(meanOf(hardware) / meanOf(software), 1.0, 1e-3);
}

void expectSamePictures(const Scene& scene) {
    for (const Technique technique : {Technique::Deferred, Technique::PathTracer})
        expectSamePicture(scene, shadowedSettings(technique));
}

TEST_F(HardwareRays, ShowTheSameCornellBox) { expectSamePictures(cornellBox()); }

TEST_F(HardwareRays, ShowTheSameInstances) { expectSamePictures(roomOfInstances()); }

TEST_F(HardwareRays, ShowTheSameHoles) { expectSamePictures(translucentRoom()); }

TEST_F(HardwareRays, ShowTheSameToEveryPassThatTraces) {
    const Scene scene = roomOfInstances();
    RenderSettings settings = shadowedSettings(Technique::Deferred);
    settings.gbuffer = GBufferBy::Rays;
    settings.clamp = ClampMode::Compensate;
    settings.shadowRays = 4;
    expectSamePicture(scene, settings);
    for (const Technique technique : {Technique::Forward, Technique::ForwardPrepass}) {
        settings = shadowedSettings(technique);
        settings.clamp = ClampMode::Compensate;
        expectSamePicture(scene, settings);
    }
}

struct Answers {
    std::vector<uint32_t> occluded;
    std::vector<shared::RayHit> hits;
};

Answers castBy(RaysBy rays, Scene scene, const RaySet& set) {
    scene.materials.resize(std::max<size_t>(scene.materials.size(), 1));
    RayCaster caster(device(), scene, buildBvh(scene), rays);
    caster.load(set);
    caster.trace(RayKind::AnyHit);
    Answers answers{caster.occludedFlags(), {}};
    caster.trace(RayKind::ClosestHit);
    answers.hits = caster.hits();
    return answers;
}

/// Rays aimed at random: hardly any passes within rounding of an outline.
void expectSameHits(const Scene& scene, const RaySet& set) {
    const Answers software = castBy(RaysBy::Software, scene, set);
    const Answers hardware = castBy(RaysBy::Hardware, scene, set);
    size_t others = 0;
    for (size_t i = 0; i < set.size(); ++i) {
        const shared::RayHit& a = software.hits[i];
        const shared::RayHit& b = hardware.hits[i];
        EXPECT_EQ(hardware.occluded[i] != 0, b.triangle != shared::kNoHit) << "ray " << i;
        others += a.triangle != b.triangle || software.occluded[i] != hardware.occluded[i] ? 1 : 0;
        if (a.triangle != b.triangle || a.triangle == shared::kNoHit) continue;
        ASSERT_NEAR(a.t, b.t, 1e-5f * a.t) << "ray " << i;
        ASSERT_NEAR(a.barycentrics.x, b.barycentrics.x, 1e-3f) << "ray " << i;
        ASSERT_NEAR(a.barycentrics.y, b.barycentrics.y, 1e-3f) << "ray " << i;
    }
    EXPECT_LE(others, set.size() / 5000);
}

TEST_F(HardwareRays, MeetTheSameTriangles) {
    const RaySet rays = randomRays(20000, 1);
    expectSameHits(triangleSoup(800, 0.2f, 1), rays);
    expectSameHits(roomOfInstances(), rays);
}

TEST_F(HardwareRays, ThatGoNowhereOrMeetNothingMiss) {
    const RaySet rays = {
        {{0, 0, 0}, 1e10f, {0, 0, 0}, 0}, {{0, 0, 0}, 1e10f, {0, 0, 1}, 0}, {{0, 0, 0}, 0.0f, {0, 0, 1}, 0}};
    EXPECT_EQ(castBy(RaysBy::Hardware, closedBox(4), rays).occluded, (std::vector<uint32_t>{0, 1, 0}));
    EXPECT_EQ(castBy(RaysBy::Hardware, Scene{}, rays).occluded, (std::vector<uint32_t>{0, 0, 0}));
}

TEST_F(HardwareRays, FollowInstancesThatMove) {
    Scene scene = roomOfInstances();
    RenderSettings settings = shadowedSettings(Technique::Deferred);
    settings.gbuffer = GBufferBy::Rays;
    settings.rays = RaysBy::Hardware;
    Renderer renderer(device(), scene, settings, pipelines());
    renderer.renderFrame();
    const Image before = renderer.radiance();
    scene.instances[0].center.x += 0.1f;
    renderer.sceneMoved(settings);
    renderer.renderFrame();
    EXPECT_FALSE(sameBits(renderer.radiance(), before));
    EXPECT_TRUE(sameBits(renderer.radiance(), render(scene, settings)));
}

TEST_F(HardwareRays, NeedNoNodesAndCountTheirOwnMemory) {
    RenderSettings settings = shadowedSettings(Technique::PathTracer);
    settings.rays = RaysBy::Hardware;
    const Scene scene = cornellBox();
    const Renderer renderer(device(), scene, settings, pipelines());
    EXPECT_TRUE(renderer.plan().hardwareRays);
    EXPECT_EQ(renderer.gpuScene().bvhNodeCount, 0u);
    EXPECT_GT(renderer.gpuScene().report()["acceleration_structure_bytes"].get<uint64_t>(), 0u);
}

using HardwareRaysAskedFor = GpuTest;  // on every device

TEST_F(HardwareRaysAskedFor, AreThereOrMissedByName) {
    RenderSettings settings = plainSettings(8, 8);
    settings.rays = RaysBy::Hardware;
    const Scene scene = cornellBox();
    if (device().canTraceRays()) {
        EXPECT_NO_THROW(Renderer(device(), scene, settings, pipelines()));
        return;
    }
    try {
        const Renderer renderer(device(), scene, settings, pipelines());
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(device().missingForRays()), std::string::npos) << error.what();
    }
}

TEST_F(HardwareRaysAskedFor, StayWhatTheyWere) {
    RenderSettings settings = plainSettings(8, 8);
    const Scene scene = cornellBox();
    Renderer renderer(device(), scene, settings, pipelines());
    settings.rays = RaysBy::Software;
    EXPECT_THROW(renderer.restart(settings), Error);
}

}  // namespace
}  // namespace manylight::test
