// manylight-bench tune as a user runs it.
#include "engine/core/file.h"
#include "engine/core/report.h"
#include "engine/gpu/tuning.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

namespace manylight::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class TuneBench : public ::testing::Test {
  protected:
    TuneBench() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~TuneBench() override { fs::remove_all(folder_); }

    int run(const std::string& arguments, const std::string& environment = "") const {
        const std::string command = fmt::format("cd '{}' && {} '{}/bin/manylight-bench' tune {} > out 2> err",
                                                folder_.string(), environment, MANYLIGHT_BINARY_DIR, arguments);
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string errors() const { return readTextFile(folder_ / "err"); }

    const std::string cube_ = fmt::format("'{}/scenes/cube.json'", MANYLIGHT_SOURCE_DIR);
    const fs::path folder_ =
        fs::path(::testing::TempDir()) /
        fmt::format("manylight_tune_{}", ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(TuneBench, MeasuresEachValueAndKeepsTheTuning) {
    ASSERT_EQ(
        run(cube_ + " --size 24x18 --turns 2 --tunables dispatch-parts,path-threads --json tune.json -o kept.json"), 0)
        << errors();
    const Json json = Json::parse(readTextFile(folder_ / "tune.json"));
    ASSERT_EQ(json["values"].size(), 2u);
    EXPECT_EQ(json["values"][0]["tunable"], "path-threads");
    EXPECT_EQ(json["tuning"].size(), gpu::tunables().size());
    for (const Json& value : json["values"]) {
        EXPECT_GE(value["candidates"].size(), 3u);
        EXPECT_EQ(value["candidates"][0]["time_ratio"]["p95"], 1.0) << "of the default to itself";
        for (const Json& candidate : value["candidates"]) {
            EXPECT_GT(candidate["milliseconds"]["median"].get<double>(), 0.0);
            EXPECT_TRUE(candidate["same_bytes"].get<bool>());
        }
        EXPECT_EQ(json["tuning"][value["tunable"].get<std::string>()], value["chosen"]);
    }
    // Whatever the timings were, what was kept is what was said.
    if (fs::exists(folder_ / "kept.json")) {
        const Json kept = Json::parse(readTextFile(folder_ / "kept.json"));
        EXPECT_EQ(kept["devices"][0]["tuning"], json["tuning"]);
        EXPECT_THAT(errors(), HasSubstr("tuning kept (kept.json)"));
    } else {
        EXPECT_THAT(errors(), HasSubstr("no tuning kept"));
    }
}

TEST_F(TuneBench, WrongInputEndsInOneLine) {
    EXPECT_EQ(run("nowhere.obj"), 1);
    EXPECT_THAT(errors(), HasSubstr("nowhere.obj"));
    EXPECT_EQ(run(cube_ + " --tunables colour"), 2);
    EXPECT_THAT(errors(), HasSubstr("'colour': expected one of gather-threads, "));
    EXPECT_EQ(run(cube_ + " --size large"), 2);
    EXPECT_EQ(run(cube_ + " -o nowhere/file.json"), 1);
    EXPECT_THAT(errors(), HasSubstr("nowhere"));
}

TEST_F(TuneBench, ProgramsReadTheFileAndSayIfItMakesNoSense) {
    writeTextFile(folder_ / "broken.json", "{");
    const std::string capture = fmt::format(
        "cd '{}' && MANYLIGHT_TUNING=broken.json '{}/bin/manylight-capture' {} -o a.exr --size 16x12 --vpls 4 "
        "--report a.json > out 2> err",
        folder_.string(), MANYLIGHT_BINARY_DIR, cube_);
    ASSERT_EQ(std::system(capture.c_str()), 0) << errors();
    EXPECT_THAT(errors(), HasSubstr("tuning files not understood"));
    EXPECT_THAT(readTextFile(folder_ / "a.json"), HasSubstr("broken.json"));
}

}  // namespace
}  // namespace manylight::test
