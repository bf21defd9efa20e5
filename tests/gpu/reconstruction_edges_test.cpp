// The filter after an interleaved gather against closed forms, and against what the picture converges to.
#include "engine/techniques/gbuffer_capture.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/test_scenes.h"

#include <algorithm>
#include <cmath>

namespace manylight::test {
namespace {

using ReconstructionEdges = GpuTest;

RenderSettings interleavedSettings(uint32_t width, uint32_t height) {
    RenderSettings settings = plainSettings(width, height);
    settings.vplCount = settings.pathCount = 256;
    settings.bounceCount = 1;
    settings.lighting = Lighting::Global;
    settings.interleave = 4;
    settings.filter = Filter::Atrous;
    return settings;
}

/// A ball of one albedo below, where all VPLs are, and of many above, where the camera looks: in a ball every VPL
/// lights every point alike.
Scene motleyBall() {
    Scene scene;
    const uint32_t grey = addMaterial(scene, glm::vec3(0.5f));
    addSphere(scene, glm::vec3(0.0f), 0.5f, 5, true, true, grey);
    const std::array colours = {addMaterial(scene, {0.9f, 0.1f, 0.3f}), addMaterial(scene, {0.2f, 0.8f, 0.0f}), grey};
    for (size_t i = 0; i < scene.triangles.size(); ++i)
        if (scene.vertices[scene.triangles[i].vertex[0]].position.y > 0.1f)
            scene.triangles[i].material = colours[i % colours.size()];
    scene.lights.push_back(spotLight(glm::vec3(0.0f), {0, -1, 0}, glm::vec3(1.0f), 0.8f, 0.8f));
    addCamera(scene, {0.0f, -0.1f, 0.0f}, {0.05f, 0.5f, 0.05f}, 1.0f);
    return finished(std::move(scene));
}

TEST_F(ReconstructionEdges, LeavesEvenLightOnAnyTextureAsItIs) {
    const Scene scene = motleyBall();
    RenderSettings settings = interleavedSettings(64, 48);
    const Image filtered = render(scene, settings);
    settings.filter = Filter::Off;
    settings.interleave = 1;
    const Image whole = render(scene, settings);
    double darkest = 1.0;
    for (size_t i = 1; i < whole.texels.size(); i += 3) {
        for (size_t c = 0; c < 3; ++c)
            ASSERT_NEAR(filtered.texels[i - 1 + c], whole.texels[i - 1 + c], 0.01f * whole.texels[i - 1 + c]) << i + c;
        darkest = std::min(darkest, double{whole.texels[i]} / largestOf(whole));
    }
    EXPECT_LT(darkest, 0.2) << "there is no texture";
}

/// A plate before a wall: only the wall sees the VPLs, which are at the side between the two.
Scene plateBeforeWall() {
    Scene scene;
    const uint32_t grey = addMaterial(scene, glm::vec3(0.5f));
    addQuad(scene, {-0.5f, -0.5f, -0.4f}, {1, 0, 0}, {0, 1, 0}, grey);
    addQuad(scene, {-0.5f, -0.5f, -0.3f}, {0, 1, 0}, {0, 0, -0.1f}, grey);
    addQuad(scene, {0.02f, -0.2f, 0.0f}, {0.2f, 0, 0}, {0, 0.2f, 0}, grey);
    scene.lights.push_back(spotLight({0.4f, 0.0f, -0.35f}, {-1, 0, 0}, glm::vec3(1.0f), 0.05f, 0.05f));
    addCamera(scene, {0.0f, 0.0f, 0.6f}, {0.05f, -0.05f, 0.0f}, 0.7f);
    return finished(std::move(scene));
}

TEST_F(ReconstructionEdges, DoesNotCarryLightAcrossEdgesAndKeepsTheMeanOfAWall) {
    const Scene scene = plateBeforeWall();
    RenderSettings settings = interleavedSettings(64, 48);
    settings.vplCount = settings.pathCount = 512;
    const Image filtered = render(scene, settings);
    settings.filter = Filter::Off;
    const Image pattern = render(scene, settings);
    settings.interleave = 1;
    const Image whole = render(scene, settings);
    Renderer renderer(device(), scene, settings, pipelines());
    const GBufferImage gbuffer = captureGBuffer(renderer, scene);

    double filteredSum = 0.0;
    double wholeSum = 0.0;
    double filteredError = 0.0;
    double patternError = 0.0;
    size_t onPlate = 0;
    for (size_t i = 0; i < gbuffer.texels.size(); ++i) {
        if (gbuffer.texels[i].position.z > -0.05f) {
            ++onPlate;
            ASSERT_LT(filtered.texels[3 * i], 1e-6 * largestOf(whole)) << i;
        }
        if (gbuffer.texels[i].position.z > -0.39f) continue;
        const double value = double{whole.texels[3 * i]};
        filteredSum += double{filtered.texels[3 * i]};
        wholeSum += value;
        filteredError += std::pow(double{filtered.texels[3 * i]} / value - 1.0, 2.0);
        patternError += std::pow(double{pattern.texels[3 * i]} / value - 1.0, 2.0);
    }
    EXPECT_GT(onPlate, 100u);
    EXPECT_GT(wholeSum, 0.0);
    EXPECT_NEAR(filteredSum, wholeSum, 0.01 * wholeSum);  // slopes cancel, how they bend does not
    EXPECT_LT(filteredError, 0.2 * patternError);         // 0.13: light falls steeply beside the VPLs
}

/// A floor below a ceiling, and a plate between them over one half of it: faint blue light from one place ends at a
/// line, and strong red light from all of the ceiling fades across it.
Scene twoColoursAboveAPlate() {
    Scene scene;
    const uint32_t white = addMaterial(scene, glm::vec3(0.8f));
    addQuad(scene, {-0.5f, -0.5f, 0.0f}, {1, 0, 0}, {0, 1, 0}, white);
    addQuad(scene, {-0.5f, -0.5f, 0.5f}, {0, 1, 0}, {1, 0, 0}, white);
    addQuad(scene, {-0.5f, -0.5f, 0.25f}, {0.5f, 0, 0}, {0, 1, 0}, white);
    scene.lights.push_back(spotLight({0.0f, 0.0f, 0.49f}, {0, 0, 1}, {0.0f, 0.0f, 8.0f}, 0.1f, 0.1f));
    scene.lights.push_back(spotLight({0.01f, 0.0f, 0.28f}, {0, 0, 1}, {1.0f, 0.0f, 0.0f}, 1.0f, 1.0f));
    addCamera(scene, {0.01f, 0.0f, 0.22f}, {0.0f, 0.0f, 0.0f}, 0.6f);
    return finished(std::move(scene));
}

// The blue is a sixth of the red: what the rays of a frame leave to chance in the brightness of both hides its edge.
TEST_F(ReconstructionEdges, KeepsShadowsOfOneColour) {
    const Scene scene = twoColoursAboveAPlate();
    RenderSettings settings = interleavedSettings(64, 48);
    settings.castShadows = true;
    settings.shadowRays = 2;
    Renderer renderer(device(), scene, settings, pipelines());
    const GBufferImage gbuffer = captureGBuffer(renderer, scene);
    double inShadow = 0.0;
    double lit = 0.0;
    double litRed = 0.0;
    size_t pixelsInShadow = 0;
    size_t pixelsLit = 0;
    for (settings.seed = 0; settings.seed < 8; ++settings.seed) {
        const Image filtered = render(scene, settings);
        for (size_t i = 0; i < gbuffer.texels.size(); ++i) {
            const float x = gbuffer.texels[i].position.x;
            if (x < -0.01f && x > -0.035f) {
                inShadow += double{filtered.texels[3 * i + 2]};
                ++pixelsInShadow;
            } else if (x > 0.025f) {
                lit += double{filtered.texels[3 * i + 2]};
                litRed += double{filtered.texels[3 * i]};
                ++pixelsLit;
            }
        }
    }
    ASSERT_GT(pixelsInShadow, 1000u);
    ASSERT_GT(pixelsLit, 1000u);
    EXPECT_LT(lit, 0.2 * litRed);
    const double leaked = inShadow / static_cast<double>(pixelsInShadow) / (lit / static_cast<double>(pixelsLit));
    EXPECT_LT(leaked, 0.027);  // 0.017, and 0.041 where edges are those of brightness
}

/// Pixels next to others whose surface faces another way.
std::vector<size_t> pixelsInCorners(const GBufferImage& gbuffer, uint32_t width) {
    std::vector<size_t> found;
    for (size_t i = 0; i + width < gbuffer.texels.size(); ++i)
        for (const size_t neighbour : {i + 1, i + width})
            if (glm::dot(gbuffer.texels[i].normal, gbuffer.texels[neighbour].normal) < 0.5f)
                found.insert(found.end(), {i, neighbour});
    return found;
}

// Light falls towards corners. A filter that took the one side of a pixel that there is would brighten them: by 5 %
// here.
TEST_F(ReconstructionEdges, DoesNotBrightenCorners) {
    const Scene scene = cornellBox();
    RenderSettings settings = plainSettings(96, 72);
    settings.lighting = Lighting::Global;
    settings.clamp = ClampMode::Bound;
    settings.castShadows = true;
    settings.bounceCount = 3;
    settings.vplCount = 256;
    Renderer renderer(device(), scene, settings, pipelines());
    const std::vector<size_t> corners = pixelsInCorners(captureGBuffer(renderer, scene), settings.width);
    ASSERT_GT(corners.size(), 200u);
    double filteredSum = 0.0;
    double wholeSum = 0.0;
    for (settings.seed = 0; settings.seed < 4; ++settings.seed) {
        settings.shadowRays = 0;
        settings.filter = Filter::Off;
        const Image whole = render(scene, settings);
        settings.shadowRays = 4;
        settings.filter = Filter::Atrous;
        const Image filtered = render(scene, settings);
        for (const size_t i : corners) {
            filteredSum += double{filtered.texels[3 * i + 1]};
            wholeSum += double{whole.texels[3 * i + 1]};
        }
    }
    EXPECT_NEAR(filteredSum, wholeSum, 0.01 * wholeSum);
}

TEST_F(ReconstructionEdges, IsNotDeclaredWhereEveryVplIsAskedForEveryRay) {
    const Scene scene = sphereInBox();
    RenderSettings settings = interleavedSettings(24, 18);
    settings.interleave = 1;
    const Image filtered = render(scene, settings);
    settings.filter = Filter::Off;
    EXPECT_TRUE(sameBits(filtered, render(scene, settings)));
}

/// The box at 64 x 48 with few but shadowed VPLs, and what it converges to.
struct BoxError {
    Scene scene = cornellBox();
    RenderSettings settings = plainSettings(64, 48);
    Image truth;

    BoxError() {
        settings.castShadows = true;
        settings.lighting = Lighting::Global;
        settings.bounceCount = 3;
        settings.vplCount = 128;
        settings.pathCount = 512;
        RenderSettings truthful = settings;
        truthful.technique = Technique::PathTracer;
        truth = render(scene, truthful, 512);
        settings.clamp = ClampMode::Bound;
    }
    double of(const RenderSettings& measured, uint32_t frames) const {
        const Image picture = render(scene, measured, frames);
        const double floor = 0.01 * meanOf(truth) * meanOf(truth);
        double sum = 0.0;
        for (size_t i = 0; i < truth.texels.size(); ++i) {
            const double expected = double{truth.texels[i]};
            sum += std::pow(double{picture.texels[i]} - expected, 2.0) / (expected * expected + floor);
        }
        return sum / static_cast<double>(truth.texels.size());
    }
};

TEST_F(ReconstructionEdges, OfTheCornellBoxErrsLittleMoreThanTheWholeGather) {
    const BoxError error;
    const double whole = error.of(error.settings, 1);
    RenderSettings interleaved = error.settings;
    interleaved.interleave = 4;
    const double pattern = error.of(interleaved, 1);
    interleaved.filter = Filter::Atrous;
    const double filtered = error.of(interleaved, 1);
    EXPECT_GT(pattern, 3.0 * whole);
    EXPECT_LT(filtered, 1.5 * whole);

    interleaved.shadowRays = 4;
    const double resampled = error.of(interleaved, 1);
    EXPECT_LT(resampled, 1.5 * whole);
}

}  // namespace
}  // namespace manylight::test
