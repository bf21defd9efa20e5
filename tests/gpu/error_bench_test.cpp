// manylight-bench error as a user runs it: a scene in, rows and a reference out, errors that say what is wrong.
#include "engine/core/file.h"
#include "engine/core/report.h"
#include "engine/image/image_io.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

namespace manylight::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

struct Outcome {
    int exitCode = -1;
    std::string errors;
};

/// Runs the program in a folder of the test's own, with a cache of its own.
class ErrorBench : public ::testing::Test {
  protected:
    ErrorBench() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~ErrorBench() override { fs::remove_all(folder_); }

    Outcome run(const std::string& arguments, const std::string& before = "") const {
        const std::string command = fmt::format(
            "cd '{}' && XDG_CACHE_HOME=cache {} '{}/bin/manylight-bench' error '{}/scenes/cube.json' {} > out "
            "2> err",
            folder_.string(), before, MANYLIGHT_BINARY_DIR, MANYLIGHT_SOURCE_DIR, arguments);
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readTextFile(folder_ / "err")};
    }
    Json runJson(const std::string& arguments) const {
        const Outcome outcome = run(arguments + " --json result.json");
        EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
        return Json::parse(readTextFile(folder_ / "result.json"));
    }

    const fs::path folder_ =
        fs::path(::testing::TempDir()) /
        fmt::format("manylight_error_{}", ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

constexpr const char* kSmall = "--size 24x18 --vpls 8 --seconds 0.3 --seeds 2 --reference-seconds 1 ";

TEST_F(ErrorBench, ErrorFallsWithTimeAndEveryRowSaysHowFar) {
    const Json json = runJson(std::string(kSmall) + "--mode clamp=compensate --mode technique=path-tracer");
    EXPECT_EQ(json["seeds"], 2);
    EXPECT_GT(json["reference"]["rmse"].get<double>(), 0.0);
    ASSERT_EQ(json["modes"].size(), 2u);
    for (const Json& mode : json["modes"]) {
        const Json& rows = mode["rows"];
        ASSERT_GE(rows.size(), 2u);
        for (size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i]["frames"], 1 << i);
        EXPECT_LT(rows.back()["seconds"].get<double>(), 3.0);
        EXPECT_LT(rows.back()["rmse"]["mean"], rows.front()["rmse"]["mean"]);
        EXPECT_EQ(rows.back()["non_finite_pixels"], 0);
        // Of two seeds the median is the mean.
        EXPECT_NEAR(rows.back()["rmse_median"].get<double>(), rows.back()["rmse"]["mean"].get<double>(), 1e-9);
        const double squared = rows.back()["bias_squared"].get<double>() + rows.back()["variance"].get<double>();
        EXPECT_GT(squared, 0.0);
    }
}

TEST_F(ErrorBench, TheReferenceIsKeptAndRefined) {
    const std::string once = std::string(kSmall) + "--no-flip --mode technique=path-tracer --reference-error ";
    const uint64_t first = runJson(once + "0.5")["reference"]["samples_per_pixel"].get<uint64_t>();
    const uint64_t same = runJson(once + "0.5")["reference"]["samples_per_pixel"].get<uint64_t>();
    const uint64_t more = runJson(once + "0.001")["reference"]["samples_per_pixel"].get<uint64_t>();
    EXPECT_EQ(same, first);
    EXPECT_GT(more, first);
    const auto count = std::distance(fs::directory_iterator(folder_ / "cache/manylight/references"), {});
    EXPECT_EQ(count, 1);
    // Another picture of the same scene is another reference.
    runJson(once + "0.5 --bounces 0");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "cache/manylight/references"), {}), 2);
}

TEST_F(ErrorBench, WrongInputEndsInOneLine) {
    const std::vector<std::string> rgb = {"R", "G", "B"};
    writeExr(folder_ / "other.exr", {{"", rgb, Image(24, 18, 3)}}, {{"manylight.scene", "another"}});
    writeExr(folder_ / "large.exr", {{"", rgb, Image(25, 18, 3)}}, {});
    const auto expectError = [&](const std::string& arguments, int exitCode, const std::string& part) {
        const Outcome outcome = run("--size 24x18 --vpls 8 --reference-seconds 1 " + arguments);
        EXPECT_EQ(outcome.exitCode, exitCode) << arguments;
        EXPECT_THAT(outcome.errors, HasSubstr(part)) << arguments;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    };
    expectError("--reference other.exr", 1, "a picture of scene another; expected scene cube");
    expectError("--reference large.exr", 1, "25x18 pixels; expected 24x18");
    expectError("--reference missing.exr", 1, "missing.exr");
    expectError("--mode clamp", 2, "expected option=value");
    expectError("--mode size=9x9", 2, "--size is the same for all modes");
    expectError("--mode clamp=soft", 2, "expected one of off, bound, compensate");
    expectError("--seconds 0.001 --paths 4096", 1, "expected time for two frames");
    expectError("--seeds 1", 2, "--seeds");
    expectError("--plot plot.gif", 2, ".png or .svg");
}

TEST_F(ErrorBench, AnInterruptKeepsTheReference) {
    std::ofstream(folder_ / "interrupt.sh") << R"("$@" & program=$!
while kill -0 $program && ! ls cache/manylight/references/*; do sleep 0.1; done > ls.out 2>&1
kill -TERM $program
wait $program
)";
    // Not after a time, which a cold start may take for itself, but once there is something to keep.
    const Outcome outcome =
        run("--size 24x18 --vpls 8 --seconds 60 --seeds 2 --reference-seconds 1", "sh interrupt.sh");
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_THAT(outcome.errors, HasSubstr("interrupted"));
    EXPECT_TRUE(fs::exists(folder_ / "cache/manylight/references"));
}

}  // namespace
}  // namespace manylight::test
