// Where something is in the way, nothing arrives: not little, but zero.
#include "engine/techniques/gbuffer_capture.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <cmath>

namespace manylight::test {
namespace {

RenderSettings shadowSettings(uint32_t vpls) {
    RenderSettings settings = plainSettings(48, 36);
    settings.castShadows = true;
    settings.vplCount = vpls;
    settings.bounceCount = -1;
    settings.russianRoulette = true;
    return settings;
}

constexpr Technique kTechniques[] = {Technique::Deferred, Technique::Forward};

using Shadows = GpuTest;

TEST_F(Shadows, AnOccluderBlocksAndItsSurroundingsAreLit) {
    Scene scene = floorFromAbove(0.5f);
    const uint32_t card = addMaterial(scene, glm::vec3(0.0f));
    addQuad(scene, {-0.1f, 0.2f, -0.1f}, {0.2f, 0, 0}, {0, 0, 0.2f}, card);
    scene.lights.push_back(pointLight({0, 0.4f, 0}, glm::vec3(1.0f)));
    scene.cameras.clear();
    addCamera(scene, {0.3f, 0.6f, 0.3f}, {0, 0, 0}, 0.8f);
    RenderSettings settings = shadowSettings(0);
    const Image shadowed = render(scene, settings);
    settings.castShadows = false;
    const Image lit = render(scene, settings);
    Renderer renderer(device(), scene, settings, pipelines());
    const GBufferImage gbuffer = captureGBuffer(renderer, scene);
    size_t dark = 0;
    for (size_t i = 0; i < gbuffer.texels.size(); ++i) {
        const GBufferTexel& texel = gbuffer.texels[i];
        if (!texel.isSurface || texel.material == card) continue;
        // The card at half the lamp's height throws a shadow twice its size; the rim is left to rounding.
        const float reach = std::max(std::abs(texel.position.x), std::abs(texel.position.z));
        if (reach < 0.2f - 1e-4f) {
            ++dark;
            ASSERT_EQ(shadowed.texels[3 * i], 0.0f) << i;
        } else if (reach > 0.2f + 1e-4f) {
            ASSERT_EQ(shadowed.texels[3 * i], lit.texels[3 * i]) << i;
        }
    }
    EXPECT_GT(dark, 100u);
    EXPECT_LT(dark, gbuffer.texels.size() / 2);
}

/// A room in two halves; the lamps are in the half that the camera is not in.
Scene twoRooms() {
    Scene scene;
    const uint32_t white = addMaterial(scene, glm::vec3(0.8f));
    addRoom(scene, {-0.5f, -0.25f, -0.25f}, {0.5f, 0.25f, 0.25f}, white);
    addQuad(scene, {0, -0.25f, -0.25f}, {0, 0.5f, 0}, {0, 0, 0.5f}, white);  // a wall of no thickness
    addQuad(scene, {-0.3f, 0.2f, -0.05f}, {0.1f, 0, 0}, {0, 0, 0.1f},
            addMaterial(scene, glm::vec3(0.0f), glm::vec3(10.0f)));
    scene.lights.push_back(pointLight({-0.01f, 0.1f, 0.1f}, glm::vec3(1.0f)));
    addCamera(scene, {0.45f, 0.1f, 0.2f}, {0.0f, -0.1f, -0.1f}, 1.4f);
    addCamera(scene, {-0.45f, 0.1f, 0.2f}, {0.0f, -0.1f, -0.1f}, 1.4f);
    return finished(std::move(scene));
}

TEST_F(Shadows, NothingLeaksThroughAWallOfNoThickness) {
    const Scene scene = twoRooms();
    for (const Technique technique : kTechniques) {
        RenderSettings settings = shadowSettings(300);
        settings.technique = technique;
        EXPECT_EQ(largestOf(render(scene, settings)), 0.0) << name(technique);
        settings.camera = 1;
        EXPECT_GT(meanOf(render(scene, settings)), 0.1) << name(technique);
    }
}

TEST_F(Shadows, ALightInAClosedBoxStaysInIt) {
    Scene scene;
    const uint32_t white = addMaterial(scene, glm::vec3(0.8f));
    addRoom(scene, glm::vec3(-0.5f), glm::vec3(0.5f), white);
    addRoom(scene, {-0.15f, -0.5f, -0.15f}, {0.15f, -0.2f, 0.15f}, white);  // on the floor: its bottom is there twice
    scene.lights.push_back(pointLight({0, -0.3f, 0}, glm::vec3(1.0f)));
    addCamera(scene, {0.4f, 0.4f, 0.4f}, {0, -0.3f, 0}, 1.2f);
    addCamera(scene, {0.1f, -0.25f, 0.1f}, {-0.1f, -0.4f, -0.1f}, 1.2f);
    scene = finished(std::move(scene));
    RenderSettings settings = shadowSettings(200);
    EXPECT_EQ(largestOf(render(scene, settings)), 0.0);
    settings.camera = 1;
    EXPECT_GT(meanOf(render(scene, settings)), 0.1);
}

TEST_F(Shadows, SmoothNormalsLetNoLightThroughACoarseSphere) {
    // The normals of a smooth sphere turn beyond the facets' own: seen from outside, some face the lamp inside.
    Scene scene;
    const uint32_t white = addMaterial(scene, glm::vec3(0.8f));
    addSphere(scene, {-0.1f, 0.0f, 0.0f}, 0.2f, 1, false, true, white);
    addRoom(scene, glm::vec3(-0.5f), glm::vec3(0.5f), white);
    scene.lights.push_back(pointLight({-0.05f, 0.02f, 0.0f}, glm::vec3(1.0f)));
    addCamera(scene, {0.45f, 0.2f, 0.4f}, {-0.1f, 0.0f, 0.0f}, 1.0f);
    scene = finished(std::move(scene));
    for (const ClampMode clamp : {ClampMode::Off, ClampMode::Compensate})
        for (const Technique technique : {Technique::Deferred, Technique::Forward, Technique::PathTracer}) {
            RenderSettings settings = shadowSettings(200);
            settings.technique = technique;
            settings.clamp = clamp;
            EXPECT_EQ(largestOf(render(scene, settings, 2)), 0.0) << name(technique) << ", " << name(clamp);
        }
}

TEST_F(Shadows, NoPixelOfAConvexRoomIsInShadow) {
    // Acne would show as pixels that lose light to the surface they are on.
    Scene scene = unevenBox();
    scene.lights.push_back(constantLight(glm::vec3(0.0f)));
    for (const Technique technique : kTechniques) {
        RenderSettings settings = shadowSettings(250);
        settings.technique = technique;
        const Image shadowed = render(scene, settings);
        settings.castShadows = false;
        const Image lit = render(scene, settings);
        for (size_t i = 0; i < lit.texels.size(); ++i)
            ASSERT_NEAR(shadowed.texels[i], lit.texels[i], 2e-6f * (1.0f + lit.texels[i])) << i;
    }
}

TEST_F(Shadows, TheSkyDoesNotReachIntoAClosedRoom) {
    Scene scene = closedBox(glm::vec3(0.8f));
    scene.lights = {constantLight(glm::vec3(1.0f)), directionalLight({0.3f, -1, 0.2f}, glm::vec3(2.0f))};
    EXPECT_EQ(largestOf(render(scene, shadowSettings(200))), 0.0);
}

}  // namespace
}  // namespace manylight::test
