// Light of earlier views: it helps where surfaces are still seen, and leaves no trace elsewhere.
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/instanced_scenes.h"

#include <cmath>

namespace manylight::test {
namespace {

using Temporal = GpuTest;

RenderSettings temporalSettings(uint32_t width, uint32_t height) {
    RenderSettings settings = plainSettings(width, height);
    settings.castShadows = true;
    settings.vplCount = 32;
    settings.bounceCount = 3;
    settings.lightSampleCount = 4;
    settings.clamp = ClampMode::Compensate;
    settings.temporal = true;
    return settings;
}

RenderSettings without(RenderSettings settings) {
    settings.temporal = false;
    return settings;
}

/// Nothing but a point light: frames do not differ.
RenderSettings pointLit(uint32_t width, uint32_t height) {
    RenderSettings settings = plainSettings(width, height);
    settings.castShadows = true;
    settings.lighting = Lighting::Local;
    settings.temporal = true;
    return settings;
}

/// Sideways, with a turn.
Camera afterSteps(Camera camera, uint32_t steps) {
    const auto way = static_cast<float>(steps);
    const glm::vec3 right = glm::cross(camera.forward, camera.up);
    camera.origin += 0.008f * way * right + 0.004f * way * camera.up;
    camera.forward = glm::normalize(camera.forward + 0.01f * way * right);
    camera.up = glm::normalize(camera.up - glm::dot(camera.up, camera.forward) * camera.forward);
    return camera;
}

/// Renders a frame from each of `views` places, the scene's camera first; ends at the last.
void glide(Renderer& renderer, const Camera& from, uint32_t views) {
    for (uint32_t view = 0; view < views; ++view) {
        if (view > 0) renderer.lookThrough(afterSteps(from, view));
        renderer.renderFrame();
    }
}

double rootMeanSquare(const Image& a, const Image& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.texels.size(); ++i) sum += std::pow(double{a.texels[i]} - double{b.texels[i]}, 2);
    return std::sqrt(sum / static_cast<double>(a.texels.size()));
}

TEST_F(Temporal, WithoutMovementThePictureIsAsItWas) {
    const Scene scene = sphereInBox();
    const RenderSettings settings = temporalSettings(32, 24);
    for (const uint32_t frames : {1u, 3u})
        EXPECT_TRUE(sameBits(render(scene, settings, frames), render(scene, without(settings), frames))) << frames;
}

// Eight frames of independent errors would leave 0.35 of them.
TEST_F(Temporal, AMovingCameraSeesHalfTheError) {
    const Scene scene = sphereInBox();
    const RenderSettings settings = temporalSettings(64, 48);
    const Camera camera = scene.cameras.front();
    constexpr uint32_t kViews = 8;
    Renderer moving(device(), scene, settings);
    glide(moving, camera, kViews);
    const Image shown = moving.radiance();

    RenderSettings converged = without(settings);
    Renderer still(device(), scene, converged);
    still.lookThrough(afterSteps(camera, kViews - 1));
    still.renderFrame();
    const Image single = still.radiance();
    converged.vplCount = 512;
    converged.lightSampleCount = 64;
    still.restart(converged);
    for (int frame = 0; frame < 6; ++frame) still.renderFrame();
    const Image truth = still.radiance();
    EXPECT_LT(rootMeanSquare(shown, truth), 0.5 * rootMeanSquare(single, truth))
        << rootMeanSquare(shown, truth) << " and " << rootMeanSquare(single, truth);
    EXPECT_NEAR(meanOf(shown), meanOf(truth), 0.05 * meanOf(truth));
}

// As a viewer comes to rest: with more pixels, and a new place in them for every frame.
TEST_F(Temporal, WhatComesToRestEndsAsThePictureWithout) {
    const Scene scene = sphereInBox();
    RenderSettings settings = temporalSettings(16, 12);
    const Camera camera = scene.cameras.front();
    constexpr uint32_t kViews = 12;
    Renderer renderer(device(), scene, settings);
    glide(renderer, camera, kViews);
    settings.width = 24;
    settings.height = 18;
    settings.jitter = true;
    renderer.restart(settings);
    Renderer still(device(), scene, without(settings));
    still.lookThrough(afterSteps(camera, kViews - 1));
    for (uint32_t frame = 1; frame <= 7; ++frame) {
        renderer.renderFrame();
        still.renderFrame();
        if (frame == 1) EXPECT_FALSE(sameBits(renderer.radiance(), still.radiance())) << "nothing was handed over";
    }
    EXPECT_TRUE(sameBits(renderer.radiance(), still.radiance()))
        << "12 frames of 16 x 12 stand for less than 6 of 24 x 18";
}

/// A card before the back wall of a room.
constexpr float kCardSize = 0.12f;  // half a side
constexpr float kCardDepth = -0.1f;
Scene cardInRoom() {
    Scene scene;
    addQuad(scene, {-kCardSize, -kCardSize, 0}, {2 * kCardSize, 0, 0}, {0, 2 * kCardSize, 0},
            addMaterial(scene, {0.9f, 0.1f, 0.1f}));
    endMesh(scene);
    addRoom(scene, glm::vec3(-0.5f), glm::vec3(0.5f), addMaterial(scene, glm::vec3(0.4f)));
    endMesh(scene);
    addInstance(scene, 0, glm::mat3(1.0f), {0, 0, kCardDepth});
    addInstance(scene, 1, glm::mat3(1.0f), glm::vec3(0.0f));
    scene.lights.push_back(pointLight({0.1f, 0.3f, 0.4f}, glm::vec3(1.0f)));
    addCamera(scene, {-0.12f, 0.0f, 0.45f}, {-0.12f, 0.0f, -0.5f}, 1.2f);
    return finishedInstances(std::move(scene));
}

TEST_F(Temporal, WhatWasHiddenShowsNothingOfWhatHidIt) {
    const Scene scene = cardInRoom();
    const RenderSettings settings = pointLit(64, 48);
    const Camera before = scene.cameras.front();
    Camera after = before;
    after.origin.x = 0.12f;
    Renderer renderer(device(), scene, settings);
    for (int frame = 0; frame < 5; ++frame) renderer.renderFrame();
    renderer.lookThrough(after);
    renderer.renderFrame();
    const Image shown = renderer.radiance();
    Renderer fresh(device(), scene, without(settings));
    fresh.lookThrough(after);
    fresh.renderFrame();
    const Image own = fresh.radiance();

    const auto isOnCard = [](const glm::vec3& from, const glm::vec3& to, float size) {
        const float share = (kCardDepth - from.z) / (to.z - from.z);
        const glm::vec3 point = glm::mix(from, to, share);
        return std::max(std::abs(point.x), std::abs(point.y)) < size;
    };
    uint32_t hidden = 0;
    for (uint32_t y = 0; y < 48; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            const float side = std::tan(0.6f) / 24.0f;  // of a pixel, at distance 1
            const float depth = after.origin.z + 0.5f;
            const glm::vec3 wall{after.origin.x + (float(x) - 31.5f) * side * depth, (23.5f - float(y)) * side * depth,
                                 -0.5f};
            if (std::max(std::abs(wall.x), std::abs(wall.y)) > 0.5f) continue;
            if (isOnCard(after.origin, wall, 1.1f * kCardSize) || !isOnCard(before.origin, wall, 0.9f * kCardSize))
                continue;
            ++hidden;
            for (uint32_t c = 0; c < 3; ++c) ASSERT_EQ(shown.at(x, y, c), own.at(x, y, c)) << x << ", " << y;
        }
    EXPECT_GT(hidden, 60u);
}

TEST_F(Temporal, WhatMovesLeavesNoTrail) {
    Scene scene = cardInRoom();
    const RenderSettings settings = pointLit(64, 48);
    Renderer renderer(device(), scene, settings);
    for (int frame = 0; frame < 5; ++frame) renderer.renderFrame();
    for (int step = 1; step <= 3; ++step) {
        scene.instances[0].center.x = 0.06f * static_cast<float>(step);
        renderer.sceneMoved(settings);
        renderer.renderFrame();
        const Image shown = renderer.radiance();
        const Image own = render(scene, without(settings));
        uint32_t wrong = 0;  // but for edges of shadows, which are a pixel wide
        for (size_t i = 0; i < own.texels.size(); ++i)
            if (std::abs(shown.texels[i] - own.texels[i]) > 0.05f * own.texels[i]) ++wrong;
        EXPECT_LT(wrong, own.texels.size() / 50) << "step " << step;
    }
}

TEST_F(Temporal, LightsThatGoOutLeaveNoLight) {
    Scene scene = cardInRoom();
    Renderer renderer(device(), scene, pointLit(32, 24));
    glide(renderer, scene.cameras.front(), 5);
    EXPECT_GT(meanOf(renderer.radiance()), 0.0);
    scene.lights.clear();
    renderer.relight(scene);
    renderer.renderFrame();
    EXPECT_EQ(largestOf(renderer.radiance()), 0.0);
}

TEST_F(Temporal, TheSameViewsGiveTheSameBytes) {
    const Scene scene = sphereInBox();
    RenderSettings settings = temporalSettings(32, 24);
    settings.interleave = 2;
    settings.filter = Filter::Atrous;
    Image pictures[2];
    for (Image& picture : pictures) {
        Renderer renderer(device(), scene, settings);
        glide(renderer, scene.cameras.front(), 4);
        picture = renderer.radiance();
    }
    EXPECT_TRUE(sameBits(pictures[0], pictures[1]));
    settings = without(settings);
    settings.technique = Technique::Forward;
    settings.interleave = 1;
    settings.filter = Filter::Off;
    Renderer renderer(device(), scene, settings);
    settings.temporal = true;
    EXPECT_THROW(renderer.restart(settings), Error) << "forward shading knows of no surfaces";
}

}  // namespace
}  // namespace manylight::test
