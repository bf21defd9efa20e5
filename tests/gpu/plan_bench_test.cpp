// manylight-bench plan as a user runs it.
#include "engine/core/file.h"
#include "engine/core/report.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

namespace manylight::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class PlanBench : public ::testing::Test {
  protected:
    PlanBench() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~PlanBench() override { fs::remove_all(folder_); }

    int run(const std::string& arguments) const {
        const std::string command = fmt::format("cd '{}' && '{}/bin/manylight-bench' plan {} > out 2> err",
                                                folder_.string(), MANYLIGHT_BINARY_DIR, arguments);
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string errors() const { return readTextFile(folder_ / "err"); }

    const std::string cube_ = fmt::format("'{}/scenes/cube.json'", MANYLIGHT_SOURCE_DIR);
    const fs::path folder_ =
        fs::path(::testing::TempDir()) /
        fmt::format("manylight_plan_{}", ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(PlanBench, WhatIsLeftOutCostsTimeOrMemoryAndDoesNotShow) {
    ASSERT_EQ(run(cube_ + " --size 24x18 --vpls 8 --frames 2 --decisions 'vertex colours' --json plan.json"), 0)
        << errors();
    const Json scene = Json::parse(readTextFile(folder_ / "plan.json"))["scenes"].at(0);
    std::vector<std::string> names;
    for (const Json& variant : scene["variants"]) {
        names.push_back(variant["kept"]);
        EXPECT_TRUE(variant["same_bytes"].get<bool>()) << names.back();
        EXPECT_GT(variant["pipelines"].get<int>(), 4);
        EXPECT_GT(variant["start_seconds"].get<double>(), 0.0);
        EXPECT_GT(variant["milliseconds"]["median"].get<double>(), 0.0);
        EXPECT_TRUE(variant["pass_milliseconds"].contains("vpl_light")) << variant["pass_milliseconds"];
    }
    EXPECT_THAT(names, ElementsAre("as planned", "vertex colours", "as planned, again", "--plan off"));
    const auto bytes = [&](size_t i) { return scene["variants"][i]["device_bytes"].get<uint64_t>(); };
    const uint64_t colourBytes = scene["triangles"].get<uint64_t>() * 3 * sizeof(uint64_t);
    EXPECT_GE(bytes(1), bytes(0) + colourBytes - 16);  // an empty buffer has 16 bytes
    EXPECT_EQ(bytes(2), bytes(0));
    EXPECT_GT(bytes(3), bytes(1));
    const auto unlike = [&](size_t i) { return scene["variants"][i]["pipelines_unlike_planned"].get<int>(); };
    const auto isSameWork = [&](size_t i) { return scene["variants"][i]["same_work"].get<bool>(); };
    EXPECT_EQ(unlike(2), 0);
    EXPECT_TRUE(isSameWork(2));
    EXPECT_GT(unlike(1), 0);
    EXPECT_FALSE(isSameWork(1));
    EXPECT_GT(scene["variants"][3]["passes_unlike_planned"].get<int>(), 0);
    EXPECT_FALSE(isSameWork(3));
}

TEST_F(PlanBench, OutputsThatAllAreAskedForAreNotSaved) {
    ASSERT_EQ(run(cube_ +
                  " --size 24x18 --vpls 8 --frames 2 --decisions 'variance of pixels' --all-outputs --json plan.json"),
              0)
        << errors();
    const Json variants = Json::parse(readTextFile(folder_ / "plan.json"))["scenes"].at(0)["variants"];
    ASSERT_EQ(variants.size(), 4u);
    EXPECT_EQ(variants[1]["device_bytes"], variants[0]["device_bytes"]);
    for (const char* pass : {"variance", "vpl_cut_off", "tonemap"})
        EXPECT_TRUE(variants[0]["pass_milliseconds"].contains(pass)) << variants[0]["pass_milliseconds"];
}

// A scene that needs everything costs no more for being planned: not by the clock, whose noise is larger, but by what
// runs.
TEST_F(PlanBench, OfASceneThatNeedsEverythingTheSameWorkIsLeft) {
    const std::string scenes = fmt::format("cd '{}' && '{}/bin/manylight-scenes' showcase -o . > out 2> err",
                                           folder_.string(), MANYLIGHT_BINARY_DIR);
    ASSERT_EQ(std::system(scenes.c_str()), 0) << errors();
    ASSERT_EQ(run("showcase.json --instances share --all-outputs --decisions 'variance of pixels' --size 24x18 --vpls "
                  "8 --paths 16 --frames 2 --json "
                  "plan.json"),
              0)
        << errors();
    const Json variants = Json::parse(readTextFile(folder_ / "plan.json"))["scenes"].at(0)["variants"];
    EXPECT_EQ(variants.back()["kept"], "--plan off");
    EXPECT_TRUE(variants.back()["same_work"].get<bool>()) << variants;
}

TEST_F(PlanBench, WrongInputEndsInOneLine) {
    EXPECT_EQ(run(""), 2);
    EXPECT_THAT(errors(), HasSubstr("no scene given"));
    EXPECT_EQ(run("nowhere.obj"), 1);
    EXPECT_THAT(errors(), HasSubstr("nowhere.obj"));
    EXPECT_EQ(run(cube_ + " --decisions colours"), 2);
    EXPECT_THAT(errors(), HasSubstr("'colours': expected one of textures, "));
}

}  // namespace
}  // namespace manylight::test
