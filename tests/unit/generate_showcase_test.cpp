#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/scene/generate/showcase.h"
#include "engine/scene/import.h"
#include "engine/scene/scene_plan.h"

#include <fmt/format.h>

#include <algorithm>

namespace manylight {
namespace {

namespace fs = std::filesystem;

/// A folder of this test's own, removed at the end.
class ShowcaseTest : public testing::Test {
  protected:
    ShowcaseTest() { fs::remove_all(folder_); }
    ~ShowcaseTest() override { fs::remove_all(folder_); }

    Scene importAs(InstanceMode mode) const { return importScene(folder_ / "showcase.json", {.instances = mode}); }

    const fs::path folder_ =
        fs::path(testing::TempDir()) /
        fmt::format("manylight_showcase_{}", testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(ShowcaseTest, ImportsWithoutWarnings) {
    const ShowcaseFiles files = writeShowcase({}, folder_);
    EXPECT_NEAR(static_cast<double>(files.trianglesShown), 25'000.0, 2'500.0);
    const Scene repeated = importAs(InstanceMode::Flatten);
    EXPECT_TRUE(repeated.warnings.empty()) << repeated.warnings.toText();
    EXPECT_EQ(repeated.triangles.size(), files.trianglesShown);
    const Scene shared = importAs(InstanceMode::Share);
    EXPECT_TRUE(shared.warnings.empty()) << shared.warnings.toText();
    EXPECT_LT(shared.triangles.size(), repeated.triangles.size());
    ASSERT_EQ(shared.cameras.size(), 1u);
    EXPECT_EQ(shared.cameras[0].resolution, glm::uvec2(320, 240));
    const auto isSpot = [](const Light& light) { return light.type == LightType::Spot; };
    EXPECT_EQ(std::ranges::count_if(shared.lights, isSpot), 2);
    EXPECT_EQ(shared.lights.size(), 3u);
}

TEST_F(ShowcaseTest, SharedNothingIsLeftOut) {
    writeShowcase({}, folder_);
    const Scene scene = importAs(InstanceMode::Share);
    std::vector<std::string> kept;
    std::vector<std::string> leftOut;
    for (const PlanDecision& decision : planScene(scene).decisions)
        (decision.leftOut ? leftOut : kept).push_back(decision.what);
    EXPECT_THAT(kept, testing::ElementsAre("textures", "mipmaps", "second uvs", "shading normals", "normal maps",
                                           "glossy reflection", "opacity at hits", "culling of back faces",
                                           "vertex colours", "emission that varies over a triangle",
                                           "two levels of rays", "matrices of normals", "environment map",
                                           "alias table of emitters", "samples of area lights", "light paths"));
    EXPECT_THAT(leftOut, testing::ElementsAre("repeated triangles", kPlanPixelVariance, kPlanCutOff, kPlanDisplay));
    const auto has = [&](AlphaMode mode) {
        return std::ranges::any_of(scene.triangles,
                                   [&](const Triangle& t) { return scene.materials[t.material].alphaMode == mode; });
    };
    EXPECT_TRUE(has(AlphaMode::Mask));
    EXPECT_TRUE(has(AlphaMode::Blend));
}

TEST_F(ShowcaseTest, IsAFunctionOfItsSeed) {
    const std::vector<fs::path> first = writeShowcase({}, folder_ / "first").written;
    const std::vector<fs::path> second = writeShowcase({}, folder_ / "second").written;
    ASSERT_EQ(first.size(), second.size());
    for (size_t i = 0; i < first.size(); ++i)
        EXPECT_TRUE(readTextFile(first[i]) == readTextFile(second[i])) << second[i];
    writeShowcase({.seed = 2}, folder_ / "second");
    EXPECT_FALSE(readTextFile(first.end()[-2]) == readTextFile(second.end()[-2])) << second.end()[-2];
}

TEST_F(ShowcaseTest, UnwritableFoldersAreErrors) {
    fs::create_directories(folder_);
    writeTextFile(folder_ / "file", "");
    EXPECT_THROW(writeShowcase({}, folder_ / "file"), Error);
}

}  // namespace
}  // namespace manylight
