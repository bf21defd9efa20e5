// Surfaces that are more than Lambertian: VPLs show what the path tracer shows, in deferred and in forward shading.
#include "tests/gpu/test_scenes.h"
#include "tests/gpu/z_test.h"

namespace manylight::test {
namespace {

constexpr uint32_t kSeeds = 32;
constexpr double kPlanted = 1.02;

struct Case {
    const char* name;
    Scene (*scene)();
    double largestError;
    uint32_t frames;
    double rounding = 1e-5;  // between forward and deferred: diffuse albedo has 21 bits in the G-buffer
};

class Materials : public GpuTest, public ::testing::WithParamInterface<Case> {};

INSTANTIATE_TEST_SUITE_P(Scenes, Materials,
                         ::testing::Values(Case{"Glossy", glossyRoom, 0.004, 10},
                                           Case{"Patterned", patternedRoom, 0.0045, 4},
                                           Case{"Translucent", translucentRoom, 0.0045, 8,
                                                // By its bits a ray is let through or not, and rounding changes them.
                                                0.05},
                                           Case{"Bumpy", bumpyRoom, 0.006, 4}),
                         [](const auto& test) { return std::string(test.param.name); });

RenderSettings pictureSettings() {
    RenderSettings settings = plainSettings(12, 9);
    settings.castShadows = true;
    settings.russianRoulette = true;
    settings.bounceCount = 6;
    settings.vplCount = 400;
    settings.lightSampleCount = 16;
    settings.clamp = ClampMode::Compensate;
    settings.clampBound = 3.0f;
    return settings;
}

PictureSamples truthOf(const Scene& scene, RenderSettings settings, uint32_t frames) {
    settings.technique = Technique::PathTracer;
    settings.clamp = ClampMode::Off;
    return samplePictures(scene, settings, {.first = 1000, .count = kSeeds, .frames = frames});
}

TEST_P(Materials, CompensatedVplsShowWhatThePathTracerShows) {
    const Scene scene = GetParam().scene();
    RenderSettings settings = pictureSettings();
    const PictureSamples truth = truthOf(scene, settings, 24 * GetParam().frames);
    const PictureSamples deferred = samplePictures(scene, settings, {.count = kSeeds, .frames = GetParam().frames});
    expectSameMeans(deferred, truth, GetParam().largestError);
    EXPECT_TRUE(toldApart(scaled(deferred, kPlanted), truth));
    settings.technique = Technique::ForwardPrepass;
    settings.vplCount = 100;
    expectSameMeans(samplePictures(scene, settings, {.count = kSeeds, .frames = 2}), truth, 0.02);
}

TEST_P(Materials, ForwardShadesAsDeferredDoes) {
    const Scene scene = GetParam().scene();
    RenderSettings settings = pictureSettings();
    settings.width = 48;
    settings.height = 36;
    settings.vplCount = 64;
    const Image deferred = render(scene, settings);
    for (const Technique technique : {Technique::Forward, Technique::ForwardPrepass}) {
        settings.technique = technique;
        const Image forward = render(scene, settings);
        double difference = 0.0;
        for (size_t i = 0; i < forward.texels.size(); ++i)
            difference += std::abs(double{forward.texels[i]} - double{deferred.texels[i]});
        EXPECT_LT(difference / static_cast<double>(forward.texels.size()), GetParam().rounding * meanOf(deferred))
            << name(technique);
    }
}

TEST_P(Materials, LeavingNothingOutChangesNoPicture) {
    const Scene scene = GetParam().scene();
    for (const Technique technique : {Technique::Deferred, Technique::Forward, Technique::PathTracer}) {
        RenderSettings settings = pictureSettings();
        settings.technique = technique;
        const Image planned = render(scene, settings);
        settings.plan = false;
        const Image everything = render(scene, settings);
        double difference = 0.0;
        for (size_t i = 0; i < planned.texels.size(); ++i)
            difference += std::abs(double{planned.texels[i]} - double{everything.texels[i]});
        // Sums of irradiance times one reflectance, or sums of reflected radiance: rounding differs.
        EXPECT_LT(difference / static_cast<double>(planned.texels.size()), 1e-5 * meanOf(planned)) << name(technique);
    }
}

using MaterialsOnce = GpuTest;

TEST_F(MaterialsOnce, TheCameraLooksThroughABackThatLightDoesNotPass) {
    Scene scene = floorFromAbove(0.5f);
    const uint32_t card = addMaterial(scene, glm::vec3(0.9f));
    addQuad(scene, {-0.5f, 0.3f, -0.5f}, {1, 0, 0}, {0, 0, 1}, card);  // its front is below
    scene.lights.push_back(pointLight({0.1f, 0.2f, 0.1f}, glm::vec3(1.0f)));
    scene = finished(std::move(scene));
    for (const Technique technique :
         {Technique::Deferred, Technique::Forward, Technique::ForwardPrepass, Technique::PathTracer}) {
        RenderSettings settings = plainSettings(8, 8);
        settings.technique = technique;
        settings.castShadows = true;
        settings.lighting = Lighting::Local;
        scene.materials[card].culled = false;
        const Image hidden = render(scene, settings);
        scene.materials[card].culled = true;
        const Image floor = render(scene, settings);
        EXPECT_EQ(meanOf(hidden), 0.0) << name(technique);  // the card's upper side is in the dark
        EXPECT_GT(meanOf(floor), 0.1) << name(technique);
        // The camera sees through, a lamp above does not shine through.
        scene.lights[0].position.y = 0.5f;
        EXPECT_EQ(meanOf(render(scene, settings)), 0.0) << name(technique);
        scene.lights[0].position.y = 0.2f;
    }
}

}  // namespace
}  // namespace manylight::test
