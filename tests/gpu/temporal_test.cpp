// Light of earlier views: it helps where surfaces are still seen, and leaves no trace elsewhere.
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/instanced_scenes.h"

#include <cmath>

namespace manylight::test {
namespace {

using Temporal = GpuTest;

/// Noisy: few VPLs, of other paths in every frame, and a lamp.
RenderSettings temporalSettings(uint32_t width, uint32_t height) {
    RenderSettings settings = plainSettings(width, height);
    settings.vplCount = 32;
    settings.bounceCount = 3;
    settings.lightSampleCount = 4;
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
    Renderer renderer(device(), scene, settings, pipelines());
    std::vector<Image> pictures;
    for (int frame = 0; frame < 3; ++frame) {
        renderer.renderFrame();
        pictures.push_back(renderer.radiance());
    }
    renderer.restart(without(settings));
    for (const Image& picture : pictures) {
        renderer.renderFrame();
        EXPECT_TRUE(sameBits(renderer.radiance(), picture));
    }
}

// Eight frames of independent errors would leave 0.35 of them.
TEST_F(Temporal, AMovingCameraSeesHalfTheError) {
    const Scene scene = sphereInBox();
    RenderSettings settings = temporalSettings(64, 48);
    settings.castShadows = true;
    settings.clamp = ClampMode::Compensate;  // or a few VPLs near walls would be all of the error
    Renderer renderer(device(), scene, settings, pipelines());
    glide(renderer, scene.cameras.front(), 8);
    const Image shown = renderer.radiance();

    RenderSettings converged = without(settings);
    renderer.restart(converged);
    renderer.renderFrame();
    const Image single = renderer.radiance();
    converged.vplCount = 512;
    converged.lightSampleCount = 64;
    renderer.restart(converged);
    for (int frame = 0; frame < 8; ++frame) renderer.renderFrame();
    const Image truth = renderer.radiance();
    EXPECT_LT(rootMeanSquare(shown, truth), 0.5 * rootMeanSquare(single, truth))
        << rootMeanSquare(shown, truth) << " and " << rootMeanSquare(single, truth);
}

// As a viewer comes to rest: with more pixels, and a new place in them for every frame.
TEST_F(Temporal, WhatComesToRestEndsAsThePictureWithout) {
    const Scene scene = sphereInBox();
    const RenderSettings settings = temporalSettings(16, 12);
    RenderSettings atRest = settings;
    atRest.width = 24;
    atRest.height = 18;
    atRest.jitter = true;
    Renderer renderer(device(), scene, settings, pipelines());
    glide(renderer, scene.cameras.front(), 12);
    std::vector<Image> first;
    std::vector<Image> last;
    for (const RenderSettings& one : {atRest, without(atRest)}) {
        renderer.restart(one);
        renderer.renderFrame();
        first.push_back(renderer.radiance());
        for (int frame = 2; frame <= 7; ++frame) renderer.renderFrame();
        last.push_back(renderer.radiance());
    }
    EXPECT_FALSE(sameBits(first[0], first[1])) << "nothing was handed over";
    EXPECT_TRUE(sameBits(last[0], last[1])) << "12 frames of 16 x 12 stand for less than 6 of 24 x 18";
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
    Renderer renderer(device(), scene, settings, pipelines());
    for (int frame = 0; frame < 5; ++frame) renderer.renderFrame();
    renderer.lookThrough(after);
    renderer.renderFrame();
    const Image shown = renderer.radiance();
    renderer.restart(without(settings));
    renderer.renderFrame();
    const Image own = renderer.radiance();

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

/// Lightest over darkest of the 3 x 3 pixels around, at most.
bool isSmooth(const Image& image, uint32_t x, uint32_t y, float contrast) {
    for (uint32_t c = 0; c < 3; ++c) {
        float low = image.at(x, y, c);
        float high = low;
        for (uint32_t row = y - 1; row <= y + 1; ++row)
            for (uint32_t column = x - 1; column <= x + 1; ++column) {
                low = std::min(low, image.at(column, row, c));
                high = std::max(high, image.at(column, row, c));
            }
        if (high > contrast * low) return false;
    }
    return true;
}

TEST_F(Temporal, WhatMovesLeavesNoTrail) {
    Scene scene = cardInRoom();
    RenderSettings settings = pointLit(64, 48);
    settings.castShadows = true;
    Renderer renderer(device(), scene, settings, pipelines());
    for (int frame = 0; frame < 5; ++frame) renderer.renderFrame();
    Image shown;
    for (int step = 1; step <= 3; ++step) {
        scene.instances[0].center.x = 0.06f * static_cast<float>(step);
        renderer.sceneMoved(settings);
        renderer.renderFrame();
        shown = renderer.radiance();
    }
    renderer.restart(without(settings));
    renderer.renderFrame();
    const Image own = renderer.radiance();
    uint32_t smooth = 0;
    for (uint32_t y = 1; y < 47; ++y)
        for (uint32_t x = 1; x < 63; ++x) {
            if (!isSmooth(own, x, y, 1.1f)) continue;
            ++smooth;
            for (uint32_t c = 0; c < 3; ++c)
                ASSERT_NEAR(shown.at(x, y, c), own.at(x, y, c), 0.05f * own.at(x, y, c)) << x << ", " << y;
        }
    EXPECT_GT(smooth, 500u);
}

TEST_F(Temporal, LightsThatGoOutLeaveNoLight) {
    Scene scene = cardInRoom();
    Renderer renderer(device(), scene, pointLit(32, 24), pipelines());
    glide(renderer, scene.cameras.front(), 5);
    EXPECT_GT(meanOf(renderer.radiance()), 0.0);
    scene.lights.clear();
    renderer.relight(scene);
    renderer.renderFrame();
    EXPECT_EQ(largestOf(renderer.radiance()), 0.0);
}

TEST_F(Temporal, TheSameViewsGiveTheSameBytes) {
    const Scene scene = sphereInBox();
    const RenderSettings settings = temporalSettings(32, 24);
    Renderer renderer(device(), scene, settings, pipelines());
    std::vector<Image> pictures;
    for (int run = 0; run < 2; ++run) {
        renderer.lookThrough(scene.cameras.front());
        renderer.forgetHistory();
        glide(renderer, scene.cameras.front(), 4);
        pictures.push_back(renderer.radiance());
    }
    EXPECT_TRUE(sameBits(pictures[0], pictures[1]));
}

TEST_F(Temporal, ForwardShadingKnowsNoSurfaces) {
    const Scene scene = sphereInBox();
    RenderSettings settings = temporalSettings(8, 6);
    settings.technique = Technique::Forward;
    EXPECT_THROW(Renderer(device(), scene, settings, pipelines()), Error);
}

}  // namespace
}  // namespace manylight::test
