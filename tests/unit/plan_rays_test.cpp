// Who traces rays: the decision and its reason, and the shaders that there are for it.
#include "engine/techniques/plan_rays.h"
#include "engine/core/error.h"
#include "engine/gpu/shader.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <string_view>

namespace manylight {
namespace {

using testing::HasSubstr;

const RayAbilities kGpu{.device = "a GPU", .missing = "", .isSoftware = false};
const RayAbilities kOldGpu{.device = "an old GPU", .missing = "VK_KHR_ray_query, rayQuery", .isSoftware = false};
const RayAbilities kCpu{.device = "a CPU", .missing = "", .isSoftware = true};

PlanDecision decisionOf(RaysBy asked, const RayAbilities& abilities) {
    ScenePlan plan;
    planRays(plan, asked, abilities);
    EXPECT_EQ(plan.decisions.size(), 1u);
    EXPECT_EQ(plan.decisions.at(0).what, kPlanHardwareRays);
    EXPECT_EQ(plan.decisions.at(0).leftOut, !plan.hardwareRays);
    return plan.decisions.at(0);
}

TEST(PlanRays, AutoTakesHardwareWhereThereIsSome) {
    EXPECT_FALSE(decisionOf(RaysBy::Auto, kGpu).leftOut);
    EXPECT_TRUE(decisionOf(RaysBy::Auto, kOldGpu).leftOut);
    EXPECT_THAT(decisionOf(RaysBy::Auto, kOldGpu).reason, HasSubstr("lacks VK_KHR_ray_query, rayQuery"));
    EXPECT_TRUE(decisionOf(RaysBy::Auto, kCpu).leftOut);
    EXPECT_THAT(decisionOf(RaysBy::Auto, kCpu).reason, HasSubstr("CPU"));
}

TEST(PlanRays, WhatIsAskedForIsTaken) {
    for (const RayAbilities& abilities : {kGpu, kOldGpu, kCpu}) {
        EXPECT_TRUE(decisionOf(RaysBy::Software, abilities).leftOut) << abilities.device;
        EXPECT_EQ(decisionOf(RaysBy::Software, abilities).reason, "--rays software") << abilities.device;
    }
    EXPECT_FALSE(decisionOf(RaysBy::Hardware, kGpu).leftOut);
    EXPECT_FALSE(decisionOf(RaysBy::Hardware, kCpu).leftOut);
    EXPECT_EQ(decisionOf(RaysBy::Hardware, kCpu).reason, "--rays hardware");
}

TEST(PlanRays, AnErrorNamesTheDeviceAndWhatItLacks) {
    ScenePlan plan;
    try {
        planRays(plan, RaysBy::Hardware, kOldGpu);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "--rays hardware: device an old GPU lacks VK_KHR_ray_query, rayQuery");
    }
}

/// Does the SPIR-V name this?
bool names(std::string_view shader, std::string_view what) {
    const std::span<const std::byte> bytes = std::as_bytes(gpu::shaderCode(shader));
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.find(what) != std::string_view::npos;
}

/// Whoever traces rays reports those that were cut off; others may only contain the functions.
bool tracesRays(std::string_view shader) {
    return names(shader, "loopBudgetExceeded") && (names(shader, "occluded(") || names(shader, "closestHit("));
}

TEST(PlanRays, EveryShaderThatTracesIsThereForBothWays) {
    const std::vector<std::string_view> shaders = gpu::shaderNames();
    size_t pairs = 0;
    for (const std::string_view shader : shaders) {
        if (shader.ends_with("+ray_query")) {
            EXPECT_TRUE(names(shader, "sceneStructure")) << shader;
            EXPECT_FALSE(names(shader, "bvhNodes")) << shader;
            continue;
        }
        EXPECT_FALSE(names(shader, "sceneStructure")) << shader;
        if (!tracesRays(shader)) continue;
        ++pairs;
        EXPECT_EQ(std::count(shaders.begin(), shaders.end(), gpu::rayQueryVariant(shader)), 1) << shader;
    }
    EXPECT_GE(pairs, 11u);
}

}  // namespace
}  // namespace manylight
