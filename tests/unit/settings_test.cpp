#include "engine/techniques/settings.h"
#include "engine/core/error.h"
#include "engine/scene/scene_plan.h"
#include "engine/techniques/gather_tuner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace manylight {
namespace {

using testing::HasSubstr;

std::string messageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Settings, EveryOptionIsAppliedFromText) {
    RenderSettings settings;
    applySetting(settings, "technique", "forward-prepass");
    applySetting(settings, "size", "17x5");
    applySetting(settings, "shadows", "off");
    applySetting(settings, "vpls", "0");
    applySetting(settings, "bounces", "-1");
    applySetting(settings, "exposure", "-1.5");
    EXPECT_EQ(settings.technique, Technique::ForwardPrepass);
    applySetting(settings, "technique", "path_tracer");  // as papers and code write it
    EXPECT_EQ(settings.technique, Technique::PathTracer);
    EXPECT_EQ(settings.width, 17u);
    EXPECT_EQ(settings.height, 5u);
    EXPECT_FALSE(settings.castShadows);
    EXPECT_EQ(settings.vplCount, 0u);
    EXPECT_EQ(settings.bounceCount, -1);
    EXPECT_EQ(settings.exposure, -1.5f);
}

TEST(Settings, ErrorsNameOptionValueAndWhatWasExpected) {
    RenderSettings settings;
    EXPECT_EQ(messageOf([&] { applySetting(settings, "technique", "warp"); }),
              "--technique warp: expected one of deferred, forward, forward-prepass, path-tracer");
    for (const char* size : {"5", "5x", "x5", "0x5", "-1x5", "5x5x5", "99999999999x1"})
        EXPECT_THAT(messageOf([&] { applySetting(settings, "size", size); }), HasSubstr("--size")) << size;
    for (const char* count : {"", "-1", "1.5", "1e3", "nan", "99999999999999999999"})
        EXPECT_THAT(messageOf([&] { applySetting(settings, "vpls", count); }), HasSubstr("--vpls")) << count;
    EXPECT_THAT(messageOf([&] { applySetting(settings, "exposure", "nan"); }), HasSubstr("--exposure nan"));
    EXPECT_THAT(messageOf([&] { applySetting(settings, "nonsense", "1"); }), HasSubstr("no such setting"));
}

TEST(Settings, SidecarSettingsAreTheSameOptionsAndErrorsNameThePlace) {
    RenderSettings settings;
    applySettings(settings, Json::parse(R"({"vpls": 32, "shadows": false, "technique": "forward"})"),
                  "a.json: settings");
    EXPECT_EQ(settings.vplCount, 32u);
    EXPECT_FALSE(settings.castShadows);
    EXPECT_EQ(settings.technique, Technique::Forward);
    EXPECT_THAT(messageOf([&] { applySettings(settings, Json::parse(R"({"vpls": "many"})"), "a.json: settings"); }),
                HasSubstr("a.json: settings.vpls: vpls many: expected a whole number"));
}

TEST(Settings, PresetsGiveWayToWhatIsGivenBesideThem) {
    RenderSettings settings;
    applySettings(settings, Json::parse(R"({"interleave": 2, "quality": "draft"})"), "a.json: settings");
    EXPECT_EQ(settings.interleave, 2u);
    EXPECT_EQ(settings.filter, Filter::Atrous);
    EXPECT_GT(settings.shadowRays, 0u);
    applySetting(settings, "quality", "final");
    RenderSettings standard;
    EXPECT_EQ(settings, standard);
    applySetting(settings, "vpls", "123");
    for (const char* quality : {"draft", "interactive", "final"}) {
        applySetting(settings, "quality", quality);
        EXPECT_EQ(settings.vplCount, 123u) << quality;
    }
}

TEST(Settings, PathsByDefaultAreSeveralForEachVplAsLongAsThereAreFew) {
    EXPECT_EQ(defaultPathCount(0), 256u);
    EXPECT_EQ(defaultPathCount(10), 256u);
    EXPECT_EQ(defaultPathCount(800), 3200u);
    EXPECT_EQ(defaultPathCount(5000), 6400u);
    EXPECT_EQ(defaultPathCount(1u << 20), 1u << 20);
}

TEST(ScenePlan, LeavesOutWhatNoTriangleUsesAndSaysWhy) {
    Scene scene;
    scene.vertices.resize(3);
    scene.triangles = {{{0, 1, 2}, 0}};
    scene.materials.resize(2);
    scene.textures.resize(1);
    scene.materials[1].albedoTexture.texture = 0;  // used by no triangle
    const ScenePlan plan = planScene(scene);
    EXPECT_FALSE(plan.textured);
    EXPECT_FALSE(plan.shadingNormals);
    EXPECT_FALSE(plan.areaLights);
    EXPECT_FALSE(plan.lightPaths);
    for (const PlanDecision& decision : plan.decisions) EXPECT_FALSE(decision.reason.empty()) << decision.what;

    scene.triangles[0].material = 1;
    scene.vertices[2].normal = {0, 1, 0};
    scene.lights.resize(1);
    const ScenePlan needed = planScene(scene);
    EXPECT_TRUE(needed.textured);
    EXPECT_TRUE(needed.shadingNormals);
    EXPECT_TRUE(needed.lightPaths);
}

TEST(ScenePlan, KeepsOneThingIfAskedTo) {
    Scene scene;
    scene.vertices.resize(3);
    scene.triangles = {{{0, 1, 2}, 0}};
    scene.materials.resize(1);
    const ScenePlan planned = planScene(scene);
    for (const PlanDecision& undone : planned.decisions) {
        if (!undone.canBeKept) {
            EXPECT_THROW(planScene(scene, false, undone.what), Error);
            continue;
        }
        const ScenePlan plan = planScene(scene, false, undone.what);
        ASSERT_EQ(plan.decisions.size(), planned.decisions.size());
        for (size_t i = 0; i < plan.decisions.size(); ++i)
            EXPECT_EQ(plan.decisions[i].leftOut, planned.decisions[i].leftOut && plan.decisions[i].what != undone.what)
                << undone.what << ", " << plan.decisions[i].what;
    }
    EXPECT_THAT(messageOf([&] { planScene(scene, false, "texture"); }),
                HasSubstr("--plan-keeps 'texture': expected one of textures, "));
}

TEST(ScenePlan, LeavesNothingOutIfAskedTo) {
    Scene scene;
    scene.vertices.resize(3);
    scene.triangles = {{{0, 1, 2}, 0}};
    scene.materials.resize(1);
    for (const PlanDecision& decision : planScene(scene, true).decisions) {
        const bool isKept = decision.canBeKept && decision.what != "two levels of rays";
        EXPECT_FALSE(isKept && decision.leftOut) << decision.what;
    }
}

TEST(GatherTuner, TriesEachCandidateTwiceAndKeepsTheFastestSecondRun) {
    GatherTuner tuner;
    std::vector<uint32_t> tried;
    for (int run = 0; !tuner.isDone(); ++run) {
        ASSERT_LT(run, 10);
        tried.push_back(tuner.pixelsPerInvocation());
        // First runs are slow (they compile), and misleadingly ordered.
        tuner.report(run < 3 ? 100.0 - run : tuner.pixelsPerInvocation() == 8 ? 1.0 : 2.0);
    }
    EXPECT_EQ(tried.size(), 6u);
    EXPECT_EQ(tuner.pixelsPerInvocation(), 8u);
}

}  // namespace
}  // namespace manylight
