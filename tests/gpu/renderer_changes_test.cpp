// A renderer that is told of changes shows what a new one would.
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <algorithm>

namespace manylight::test {
namespace {

using RendererChanges = GpuTest;

RenderSettings bouncing() {
    RenderSettings settings = plainSettings(16, 12);
    settings.vplCount = 20;
    settings.bounceCount = 2;
    settings.castShadows = true;
    return settings;
}

/// Emissive surfaces, some by a texture, and a point light.
Scene litBox() {
    Scene scene = patternedRoom();
    scene.lights = {pointLight({0.1f, 0.2f, 0.05f}, {0.2f, 0.1f, 0.3f})};
    return scene;
}

Image frameOf(Renderer& renderer) {
    renderer.renderFrame();
    return renderer.radiance();
}

TEST_F(RendererChanges, OtherLightsGiveThePictureOfASceneThatHasThem) {
    Scene scene = litBox();
    Renderer renderer(device(), scene, bouncing(), pipelines());
    const Image before = frameOf(renderer);
    scene.lights.front().position.y = -0.1f;
    scene.lights.push_back(scene.lights.front());
    scene.lights.back().type = LightType::Directional;
    renderer.relight(scene);
    const Image changed = frameOf(renderer);
    EXPECT_FALSE(sameBits(before, changed));
    EXPECT_TRUE(sameBits(changed, render(scene, bouncing())));

    scene.lights.clear();
    renderer.relight(scene);
    EXPECT_TRUE(sameBits(frameOf(renderer), render(scene, bouncing())));
}

TEST_F(RendererChanges, OtherEmissionGivesThePictureOfASceneThatHasIt) {
    const std::vector<std::pair<Materials, std::vector<float>>> cases = {{Materials::Full, {0.0f, 3.0f}},
                                                                         {Materials::Diffuse, {0.25f}}};
    for (const auto& [materials, factors] : cases) {
        Scene scene = litBox();
        RenderSettings settings = bouncing();
        settings.materials = materials;
        Renderer renderer(device(), scene, settings, pipelines());
        const Image before = frameOf(renderer);
        for (const float factor : factors) {
            for (size_t i = 0; i < scene.materials.size(); ++i)
                scene.materials[i].emittedRadiance = factor * litBox().materials[i].emittedRadiance;
            renderer.relight(scene);
            const Image changed = frameOf(renderer);
            EXPECT_FALSE(sameBits(before, changed)) << factor;
            EXPECT_TRUE(sameBits(changed, render(scene, settings))) << factor;
        }
    }
}

TEST_F(RendererChanges, ASceneThatBecameAnotherGivesItsPicture) {
    Scene scene = litBox();
    RenderSettings settings = bouncing();
    settings.materials = Materials::Diffuse;  // of which the renderer keeps a copy
    Renderer renderer(device(), scene, settings, pipelines());
    const Image before = frameOf(renderer);
    for (Vertex& vertex : scene.vertices) vertex.position.y += 0.1f * vertex.position.x * vertex.position.x;
    scene.triangles.pop_back();
    scene.lights.clear();
    renderer.sceneReplaced(settings);
    const Image replaced = frameOf(renderer);
    EXPECT_FALSE(sameBits(before, replaced));
    EXPECT_TRUE(sameBits(replaced, render(scene, settings)));
}

TEST_F(RendererChanges, AnotherCameraGivesThePictureOfASceneThatHasIt) {
    Scene scene = litBox();
    Renderer renderer(device(), scene, bouncing(), pipelines());
    const Image before = frameOf(renderer);
    Camera camera = scene.cameras.front();
    camera.origin += 0.05f * camera.up;
    camera.verticalFov *= 1.1f;
    renderer.lookThrough(camera);
    EXPECT_EQ(renderer.frameCount(), 0u);
    const Image moved = frameOf(renderer);
    EXPECT_FALSE(sameBits(before, moved));
    renderer.restart(bouncing());
    EXPECT_TRUE(sameBits(frameOf(renderer), moved)) << "restarting keeps the camera";
    scene.cameras.front() = camera;
    EXPECT_TRUE(sameBits(render(scene, bouncing()), moved));
}

TEST_F(RendererChanges, ExposureIsSeenAtOnceAndCostsNoFrame) {
    const Scene scene = litBox();
    Renderer renderer(device(), scene, bouncing(), pipelines());
    renderer.keepDisplay();
    renderer.renderFrame();
    const std::vector<uint8_t> before = renderer.displayRgba();
    renderer.setDisplay(1.5f, ToneCurve::Reinhard);
    EXPECT_EQ(renderer.frameCount(), 1u);
    const std::vector<uint8_t> changed = renderer.displayRgba();
    EXPECT_NE(changed, before);

    RenderSettings settings = bouncing();
    settings.exposure = 1.5f;
    settings.toneCurve = ToneCurve::Reinhard;
    Renderer other(device(), scene, settings, pipelines());
    other.renderFrame();
    EXPECT_EQ(changed, other.displayRgba());
}

TEST_F(RendererChanges, WhatTheBoundTakesIsShownAsItIsRecorded) {
    const Scene scene = litBox();
    RenderSettings settings = bouncing();
    settings.clamp = ClampMode::Bound;
    settings.clampBound = 0.01f;
    Renderer renderer(device(), scene, settings, pipelines());
    renderer.keepCutOff(true);
    renderer.renderFrame();
    const Image recorded = renderer.cutOff();
    EXPECT_GT(meanOf(recorded), 0.0);
    settings.show = Show::CutOff;
    EXPECT_TRUE(sameBits(render(scene, settings), recorded));

    settings.technique = Technique::Forward;
    EXPECT_THROW(render(scene, settings), Error) << "forward shading does not know it";
}

TEST_F(RendererChanges, WhatWasAskedForStaysSoInThePlan) {
    const Scene scene = litBox();
    Renderer renderer(device(), scene, bouncing(), pipelines());
    const auto leavesOut = [&](const char* what) {
        const auto found = std::ranges::find(renderer.plan().decisions, what, &PlanDecision::what);
        return found != renderer.plan().decisions.end() && found->leftOut;
    };
    EXPECT_TRUE(leavesOut(kPlanDisplay));
    EXPECT_TRUE(leavesOut(kPlanPixelVariance));
    renderer.keepDisplay();
    renderer.keepVariance(true);
    renderer.relight(scene);
    EXPECT_FALSE(leavesOut(kPlanDisplay));
    EXPECT_FALSE(leavesOut(kPlanPixelVariance));
    EXPECT_TRUE(leavesOut(kPlanCutOff));
    renderer.keepVariance(false);
    EXPECT_TRUE(leavesOut(kPlanPixelVariance));
}

}  // namespace
}  // namespace manylight::test
