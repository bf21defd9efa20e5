// The same seed gives the same bytes, and changes that must not matter do not.
#include "engine/image/image_io.h"
#include "engine/scene/normalise.h"
#include "engine/scene/scene_file.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <cmath>
#include <cstdlib>

namespace manylight::test {
namespace {

RenderSettings pictureSettings(uint32_t seed = 1) {
    RenderSettings settings = plainSettings(40, 30);
    settings.vplCount = 150;
    settings.bounceCount = -1;
    settings.russianRoulette = true;
    settings.castShadows = true;
    settings.seed = seed;
    return settings;
}

/// Every kind of estimator: plain, compensated in both ways of shading, and the path tracer.
std::vector<RenderSettings> everyWay() {
    std::vector<RenderSettings> ways(4, pictureSettings());
    ways[1].clamp = ways[2].clamp = ClampMode::Compensate;
    ways[1].clampBound = ways[2].clampBound = 3.0f;
    ways[2].technique = Technique::ForwardPrepass;
    ways[3].technique = Technique::PathTracer;
    ways[3].jitter = true;
    return ways;
}

std::string nameOf(const RenderSettings& settings) {
    return std::string(name(settings.technique)) + ", " + name(settings.clamp);
}

/// Each value is exactly 2^exponent times the other picture's.
void expectScaled(const Image& image, const Image& reference, int exponent) {
    ASSERT_EQ(image.texels.size(), reference.texels.size());
    EXPECT_GT(largestOf(reference), 0.0);
    for (size_t i = 0; i < image.texels.size(); ++i)
        ASSERT_EQ(image.texels[i], std::ldexp(reference.texels[i], exponent)) << i;
}

Scene withLightScaled(Scene scene, int exponent) {
    const float factor = std::ldexp(1.0f, exponent);
    for (Material& material : scene.materials) material.emittedRadiance *= factor;
    for (Light& light : scene.lights) light.emission *= factor;
    return scene;
}

using Determinism = GpuTest;

TEST_F(Determinism, HowManyPixelsAnInvocationShadesDoesNotShow) {
    // The renderer tries its variants one after the other on the first frames; each frame starts anew here.
    const Scene scene = cornellBox();
    RenderSettings settings;
    settings.width = 33;
    settings.height = 21;
    settings.vplCount = 100;
    settings.castShadows = false;
    Renderer renderer(device(), scene, settings, pipelines());
    renderer.renderFrame();
    const Image first = renderer.radiance();
    for (int frame = 1; frame < 7; ++frame) {
        renderer.restart(settings);
        renderer.renderFrame();
        EXPECT_EQ(renderer.radiance().texels, first.texels) << frame;
    }
}

TEST_F(Determinism, TheSameSeedGivesTheSameBytes) {
    const Scene scene = everyKindOfLight();
    for (RenderSettings settings : everyWay()) {
        SCOPED_TRACE(nameOf(settings));
        const Image first = render(scene, settings, 2);
        EXPECT_TRUE(sameBits(render(scene, settings, 2), first));
        settings.seed = 2;
        EXPECT_FALSE(sameBits(render(scene, settings, 2), first));
    }
}

TEST_F(Determinism, TheSameSeedGivesTheSameVpls) {
    const Scene scene = everyKindOfLight();
    const VplList first = renderVpls(scene, pictureSettings());
    const VplList second = renderVpls(scene, pictureSettings());
    EXPECT_EQ(first.status.vplsTraced, second.status.vplsTraced);
    EXPECT_TRUE(sameBits(first.vpls, second.vpls));
    EXPECT_FALSE(sameBits(first.vpls, renderVpls(scene, pictureSettings(2)).vpls));
}

TEST_F(Determinism, EveryEntryOfTheVplListIsUsedWherePathsSuffice) {
    const VplList list = renderVpls(unevenBox(), pictureSettings());
    EXPECT_GT(list.status.vplsTraced, 150u);
    EXPECT_EQ(list.status.vplsShaded, 150u);
    ASSERT_EQ(list.vpls.size(), 150u);
    for (const shared::LightData& vpl : list.vpls) ASSERT_GT(vpl.intensity, 0.0f);
}

TEST_F(Determinism, ARendererStartedAgainForgets) {
    const Scene scene = cornellBox();
    Renderer renderer(device(), scene, pictureSettings(), pipelines());
    renderer.renderFrame();
    const Image first = renderer.radiance();
    renderer.renderFrame();
    EXPECT_FALSE(sameBits(renderer.radiance(), first));
    EXPECT_EQ(renderer.frameCount(), 2u);
    RenderSettings other = pictureSettings(9);
    other.technique = Technique::Forward;
    renderer.restart(other);
    renderer.renderFrame();
    renderer.restart(pictureSettings());
    renderer.renderFrame();
    EXPECT_TRUE(sameBits(renderer.radiance(), first));
}

TEST_F(Determinism, FramesAreSummed) {
    // Without anything random every frame is the same, and so is their mean.
    Scene scene = closedBox(glm::vec3(0.5f));
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(0.3f)));
    expectScaled(render(scene, plainSettings(), 4), render(scene, plainSettings(), 1), 0);
}

TEST_F(Determinism, LightScaledByAPowerOfTwoScalesThePicture) {
    for (const Scene& scene : {cornellBox(), everyKindOfLight(), unevenBox()}) {
        const Image reference = render(scene, pictureSettings());
        for (const int exponent : {1, -20, 20})
            expectScaled(render(withLightScaled(scene, exponent), pictureSettings()), reference, exponent);
    }
}

TEST_F(Determinism, LightScaledByAPowerOfTwoScalesThePictureOfEveryEstimator) {
    const Scene scene = everyKindOfLight();
    for (const RenderSettings& settings : everyWay()) {
        SCOPED_TRACE(nameOf(settings));
        expectScaled(render(withLightScaled(scene, 20), settings), render(scene, settings), 20);
    }
}

TEST_F(Determinism, TheSceneScaledByAPowerOfTwoIsTheSamePicture) {
    RawScene raw = readSceneFile(std::filesystem::path(MANYLIGHT_SOURCE_DIR) / "scenes" / "cornell_box.json");
    raw.lights.push_back({.type = LightType::Point,
                          .name = "lamp",
                          .position = {100, 400, 100},
                          .emission = glm::dvec3(90000.0, 60000.0, 30000.0)});
    const Scene scene = normalise(RawScene(raw));
    for (const RenderSettings& settings : everyWay()) {
        SCOPED_TRACE(nameOf(settings));
        const Image reference = render(scene, settings);
        for (const int exponent : settings.clamp == ClampMode::Off ? std::vector<int>{-60, 61} : std::vector<int>{61}) {
            const double scale = std::ldexp(1.0, exponent);
            RawScene scaled = raw;
            for (RawVertex& vertex : scaled.vertices) vertex.position *= scale;
            for (RawCamera& camera : scaled.cameras) camera.origin *= scale;
            for (RawLight& light : scaled.lights) {
                light.position *= scale;
                light.emission *= scale * scale;
            }
            EXPECT_TRUE(sameBits(render(normalise(std::move(scaled)), settings), reference)) << exponent;
        }
    }
}

TEST_F(Determinism, WhatThePlanLeavesOutDoesNotShow) {
    for (const Scene& scene : {cornellBox(), everyKindOfLight()}) {
        SCOPED_TRACE(scene.triangles.size());
        for (RenderSettings settings : everyWay()) {
            // The shading of deferred and forward is the same: the plain scenes take one of each.
            if (scene.textures.empty() && settings.technique == Technique::Deferred && settings.clamp != ClampMode::Off)
                continue;
            const Image planned = render(scene, settings);
            settings.plan = false;
            const Image everything = render(scene, settings);
            if (settings.technique == Technique::Deferred || settings.technique == Technique::PathTracer) {
                EXPECT_TRUE(sameBits(everything, planned)) << nameOf(settings);
                continue;
            }
            // Forward shading is one large shader: what is left out of it may change how the rest is compiled to round.
            double difference = 0.0;
            for (size_t i = 0; i < planned.texels.size(); ++i)
                difference += std::abs(double{everything.texels[i]} - double{planned.texels[i]});
            EXPECT_LE(difference / static_cast<double>(planned.texels.size()), 1e-6 * meanOf(planned))
                << nameOf(settings);
        }
    }
}

TEST_F(Determinism, TheNumberOfThreadsDoesNotShow) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "manylight_threads_test";
    std::filesystem::create_directories(folder);
    std::vector<Image> pictures;
    for (const char* threads : {"1", "2", "4"}) {
        const std::string picture = (folder / threads).string() + ".exr";
        const std::string command = std::string("LP_NUM_THREADS=") + threads + " '" + MANYLIGHT_BINARY_DIR +
                                    "/bin/manylight-capture' '" + MANYLIGHT_SOURCE_DIR +
                                    "/scenes/cornell_box.json' -o '" + picture +
                                    "' --size 48x36 --vpls 100 --frames 2 --seed 5 > /dev/null 2>&1";
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        pictures.push_back(readExr(picture));
    }
    std::filesystem::remove_all(folder);
    EXPECT_GT(meanOf(pictures[0]), 0.0);
    EXPECT_TRUE(sameBits(pictures[0], pictures[1]));
    EXPECT_TRUE(sameBits(pictures[0], pictures[2]));
}

}  // namespace
}  // namespace manylight::test
