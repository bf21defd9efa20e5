// manylight-compare as a user runs it: files in; numbers, pictures and an exit code out.
#include "engine/core/file.h"
#include "engine/core/report.h"
#include "engine/image/image_io.h"
#include "engine/metrics/error.h"
#include "engine/metrics/flip.h"
#include "tests/unit/flip_pictures.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <limits>

namespace manylight::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

struct Outcome {
    int exitCode = -1;
    std::string output;
    std::string errors;
};

/// Runs the program in a folder of the test's own, where it finds test.exr and reference.exr.
class CompareProgram : public testing::Test {
  protected:
    CompareProgram() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        write("test.exr", pictures_.test);
        write("reference.exr", pictures_.reference);
    }
    ~CompareProgram() override { fs::remove_all(folder_); }

    void write(const std::string& name, const Image& image,
               const std::map<std::string, std::string>& attributes = {}) const {
        writeExr(folder_ / name, {{"", {"R", "G", "B"}, image}}, attributes);
    }

    Outcome run(const std::string& arguments) const {
        const std::string command = fmt::format("cd '{}' && '{}/bin/manylight-compare' {} > out 2> err",
                                                folder_.string(), MANYLIGHT_BINARY_DIR, arguments);
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readTextFile(folder_ / "out"),
                readTextFile(folder_ / "err")};
    }
    Json runJson(const std::string& arguments) const { return Json::parse(run(arguments + " --json").output); }

    /// Exit code 1 or 2 and one line that says all of it.
    template <typename... Parts>
    void expectError(const std::string& arguments, int exitCode, const Parts&... parts) const {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exitCode, exitCode) << arguments;
        EXPECT_THAT(outcome.errors, AllOf(HasSubstr(parts)...)) << arguments;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    }

    const fs::path folder_ =
        fs::path(testing::TempDir()) /
        fmt::format("manylight_compare_{}", testing::UnitTest::GetInstance()->current_test_info()->name());
    const PicturePair pictures_ = flipPictures("noise");
};

TEST_F(CompareProgram, PrintsWhatTheLibraryComputes) {
    const Json json = runJson("test.exr reference.exr");
    const ErrorReport error = compareImages(pictures_.test, pictures_.reference);
    const FlipResult flip = hdrFlip(pictures_.test, pictures_.reference).value();
    EXPECT_EQ(json["pixels"], 64 * 48);
    EXPECT_EQ(json["rmse"], error.rmse);
    EXPECT_EQ(json["rmse_without_worst"], error.rmseWithoutWorst);
    EXPECT_EQ(json["worst_share"], error.worstShare);
    EXPECT_EQ(json["relative_mse"], *error.relativeMse);
    EXPECT_EQ(json["smape"], *error.smape);
    EXPECT_EQ(json["flip"]["kind"], "hdr");
    EXPECT_EQ(json["flip"]["mean"], flip.mean);
    EXPECT_EQ(json["flip"]["exposures"]["count"], flip.exposures.count);
    EXPECT_EQ(json["mean_ratio"][1], *meanRatio(error, 1));
    EXPECT_EQ(json["non_finite"], 0);
    EXPECT_TRUE(json["warnings"].empty());
}

TEST_F(CompareProgram, TextAndFileSayTheSame) {
    const Outcome outcome = run("test.exr reference.exr --json-file numbers.json");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.errors, "");
    const Json json = Json::parse(readTextFile(folder_ / "numbers.json"));
    EXPECT_EQ(json, runJson("test.exr reference.exr"));
    EXPECT_THAT(outcome.output, AllOf(HasSubstr("test.exr"), HasSubstr("64 x 48 pixels, 3072 compared"),
                                      HasSubstr(fmt::format("{:.6g}", json["rmse"].get<double>())),
                                      HasSubstr(fmt::format("{:.6g}", json["flip"]["mean"].get<double>()))));
}

TEST_F(CompareProgram, CropAndMaskAreAsGoodAsSmallerPictures) {
    write("small_test.exr", cut(pictures_.test, {8, 5, 30, 20}, ""));
    write("small_reference.exr", cut(pictures_.reference, {8, 5, 30, 20}, ""));
    Json small = runJson("small_test.exr small_reference.exr");
    Json cropped = runJson("test.exr reference.exr --crop 8,5,30,20");
    for (Json* json : {&small, &cropped}) json->erase("picture"), json->erase("reference");
    EXPECT_EQ(cropped, small);

    Image mask(64, 48, 1);
    for (uint32_t y = 5; y < 25; ++y)
        for (uint32_t x = 8; x < 38; ++x) mask.at(x, y, 0) = 1.0f;
    writePng(folder_ / "mask.png", mask);
    writeExr(folder_ / "mask.exr", {{"", {"Y"}, mask}}, {});
    for (const char* name : {"mask.png", "mask.exr"}) {
        const Json masked = runJson(std::string("test.exr reference.exr --mask ") + name);
        for (const char* key : {"rmse", "relative_mse", "smape", "worst_share", "pixels", "mean_ratio"})
            EXPECT_EQ(masked[key], small[key]) << key;
        EXPECT_EQ(masked["masked_out"], 64 * 48 - 600);
    }
}

TEST_F(CompareProgram, PixelsThatAreNotFiniteFailUnlessAllowed) {
    Image broken = pictures_.test;
    broken.at(3, 4, 1) = std::numeric_limits<float>::quiet_NaN();
    write("broken.exr", broken);
    const Outcome outcome = run("broken.exr reference.exr");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.output, HasSubstr("3071 compared, 1 left out as not finite (1 in the picture, 0 in the"));
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr("warning: 1 pixels left out"), HasSubstr("1 pixels are not finite")));
    EXPECT_EQ(run("broken.exr reference.exr --allow-nonfinite").exitCode, 0);
    EXPECT_EQ(runJson("broken.exr reference.exr")["non_finite"], 1);
    // A crop without the pixel has nothing to complain about.
    EXPECT_EQ(run("broken.exr reference.exr --crop 10,10,20,20").exitCode, 0);
}

TEST_F(CompareProgram, LimitsDecideTheExitCode) {
    const double rmse = runJson("test.exr reference.exr")["rmse"];
    const auto withLimit = [&](double limit) {
        return fmt::format("--fail-above rmse={} test.exr reference.exr", limit);
    };
    EXPECT_EQ(run(withLimit(rmse)).exitCode, 0);
    expectError(withLimit(0.999 * rmse), 1, "rmse", "is above");
    expectError("test.exr reference.exr --fail-above flip=0 --fail-above bias=0 --fail-above smape=9", 1, "flip",
                "bias");
    EXPECT_EQ(run("test.exr test.exr --fail-above flip=0 --fail-above rmse=0 --fail-above bias=0").exitCode, 0);
    expectError("test.exr reference.exr --flip off --fail-above flip=1", 1, "flip is undefined");
    for (const char* limit : {"rmse", "rmse=", "=1", "speed=1", "rmse=x", "rmse=nan", "rmse=1x"})
        expectError(fmt::format("test.exr reference.exr --fail-above {}", limit), 2, "--fail-above", limit);
}

TEST_F(CompareProgram, PicturesShowTheDifference) {
    Image test = pictures_.reference;
    for (uint32_t c = 0; c < 3; ++c) test.at(20, 30, c) *= 3.0f, test.at(40, 10, c) = 0.0f;
    test.at(50, 40, 0) = std::numeric_limits<float>::infinity();
    write("changed.exr", test);
    Image mask(64, 48, 1);
    for (float& texel : mask.texels) texel = 1.0f;
    mask.at(5, 5, 0) = 0.0f;
    writePng(folder_ / "mask.png", mask);

    const Outcome outcome =
        run("changed.exr reference.exr --allow-nonfinite --mask mask.png --difference d.png "
            "--difference-range 0.25 --flip-map f.png");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.output, AllOf(HasSubstr("blue -25 % or less"), HasSubstr("f.png: FLIP")));
    const EncodedImage difference = readImage8(folder_ / "d.png");
    const EncodedImage flip = readImage8(folder_ / "f.png");
    const auto pixel = [](const EncodedImage& image, size_t x, size_t y) {
        const uint8_t* texel = &image.rgba[(y * 64 + x) * 4];
        return std::array<int, 3>{texel[0], texel[1], texel[2]};
    };
    using Rgb = std::array<int, 3>;
    EXPECT_EQ(difference.width, 64u);
    EXPECT_EQ(pixel(difference, 20, 30), (Rgb{180, 4, 38}));
    EXPECT_EQ(pixel(difference, 40, 10), (Rgb{59, 76, 192}));
    EXPECT_EQ(pixel(difference, 0, 0), (Rgb{221, 220, 220}));
    EXPECT_EQ(pixel(flip, 0, 47), (Rgb{0, 0, 4}));
    for (const EncodedImage* image : {&difference, &flip}) {
        EXPECT_EQ(pixel(*image, 50, 40), (Rgb{255, 0, 255}));
        EXPECT_EQ(pixel(*image, 5, 5), (Rgb{64, 64, 64}));
    }
    EXPECT_GT(pixel(flip, 20, 30)[0], 50);
    EXPECT_THAT(run("changed.exr reference.exr --json --difference d.png --allow-nonfinite").errors,
                HasSubstr("d.png: blue"));
}

TEST_F(CompareProgram, PngsAreDecodedAndComparedAsDisplayed) {
    const PicturePair display = flipPictures("gradient", 0.125);
    writePng(folder_ / "test.png", display.test);
    writePng(folder_ / "reference.png", display.reference);
    const Json json = runJson("test.png reference.png");
    EXPECT_EQ(json["flip"]["kind"], "ldr");
    // Steps of 1/255 in the code value are at most 2.4/1.055/255 in the linear one; half a step is what rounding loses.
    const ErrorReport exact = compareImages(display.test, display.reference);
    EXPECT_NEAR(json["rmse"].get<double>(), exact.rmse, 0.0045 * 2);
    EXPECT_NEAR(json["flip"]["mean"].get<double>(), ldrFlip(display.test, display.reference).mean, 0.01);
    expectError("test.png reference.exr", 1, "test.png", "reference.exr", "radiance");
    expectError("test.png reference.png --layer depth", 2, "only EXR files have layers");
}

TEST_F(CompareProgram, LayersAreComparedByName) {
    const Image depth = pictureOf(64, 48, [](uint32_t x, uint32_t, uint32_t) { return 1.0 + x; });
    Image plane(64, 48, 1);
    for (size_t i = 0; i < plane.texels.size(); ++i) plane.texels[i] = depth.texels[i * 3];
    const auto withLayers = [&](const std::string& name, const Image& normal) {
        writeExr(folder_ / name,
                 {{"", {"R", "G", "B"}, pictures_.test}, {"depth", {"Z"}, plane}, {"normal", {"X", "Y", "Z"}, normal}},
                 {});
    };
    withLayers("a.exr", pictures_.test);
    withLayers("b.exr", pictures_.reference);
    EXPECT_EQ(runJson("a.exr b.exr")["rmse"], 0.0);
    EXPECT_EQ(runJson("a.exr b.exr --layer depth")["rmse"], 0.0);
    const Json normals = runJson("a.exr b.exr --layer normal");
    EXPECT_EQ(normals["rmse"], compareImages(pictures_.test, pictures_.reference).rmse);
    EXPECT_TRUE(normals["flip"].is_null());
    expectError("a.exr b.exr --layer albedo", 1, "a.exr", "albedo", "normal.X");
    expectError("a.exr reference.exr --layer depth", 1, "reference.exr", "depth.Z");
    expectError("a.exr b.exr --layer normal --flip hdr", 2, "FLIP compares colours");
}

TEST_F(CompareProgram, AReferenceOfAnotherSceneIsACountedWarning) {
    const auto report = [](const std::string& scene) {
        return std::map<std::string, std::string>{{"manylight.report", Json{{"scene", scene}}.dump()}};
    };
    write("box.exr", pictures_.test, report("box"));
    write("yard.exr", pictures_.reference, report("yard"));
    const Outcome outcome = run("box.exr yard.exr");
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr("warning: 1 "), HasSubstr("\"box\""), HasSubstr("\"yard\"")));
    EXPECT_EQ(runJson("box.exr yard.exr")["warnings"][0]["count"], 1);
    EXPECT_EQ(run("box.exr box.exr").errors, "");
    EXPECT_EQ(run("box.exr reference.exr").errors, "");
}

TEST_F(CompareProgram, WrongInputIsOneClearLine) {
    write("wide.exr", Image(65, 48, 3));
    writeExr(folder_ / "half.exr", {{"", {"R", "G"}, Image(64, 48, 2)}}, {});
    writeTextFile(folder_ / "text.exr", "not a picture");
    writePng(folder_ / "mask.png", Image(10, 48, 1));
    writePng(folder_ / "black.png", Image(64, 48, 1));
    expectError("wide.exr reference.exr", 1, "wide.exr has 65 x 48", "reference.exr has 64 x 48");
    expectError("half.exr reference.exr", 1, "half.exr", "\"B\"", "G, R");
    expectError("text.exr reference.exr", 1, "text.exr", "EXR");
    expectError("absent.exr reference.exr", 1, "absent.exr");
    expectError("test.exr absent.exr", 1, "absent.exr");
    expectError("test.exr reference.exr --mask mask.png", 1, "mask.png has 10 x 48", "64 x 48");
    expectError("test.exr reference.exr --mask black.png", 1, "no pixel left", "3072 are masked out");
    expectError("test.exr reference.exr --crop 60,0,5,5", 1, "60,0,5,5", "64 x 48");
    expectError("test.exr reference.exr --crop 60,0,5", 2, "60,0,5", "x,y,width,height");
    expectError("test.exr reference.exr --difference absent/d.png", 1, "absent/d.png");
    expectError("test.exr reference.exr --difference d.exr", 2, "d.exr", ".png");
    expectError("test.exr reference.exr --flip perhaps", 2, "--flip");
    expectError("test.exr reference.exr --pixels-per-degree 0", 2, "--pixels-per-degree");
    expectError("test.exr", 2, "reference");
}

TEST_F(CompareProgram, ABlackReferenceLeavesRelativeNumbersUndefined) {
    write("black.exr", Image(64, 48, 3));
    const Json json = runJson("test.exr black.exr");
    for (const char* key : {"relative_mse", "smape"}) EXPECT_TRUE(json[key].is_null()) << key;
    EXPECT_TRUE(json["flip"]["mean"].is_null());
    EXPECT_GT(json["rmse"], 0.0);
    EXPECT_THAT(run("test.exr black.exr").output, HasSubstr("undefined"));
    EXPECT_EQ(run("test.exr black.exr --difference d.png").exitCode, 1);
    EXPECT_EQ(run("test.exr black.exr --flip-map f.png").exitCode, 1);
}

}  // namespace
}  // namespace manylight::test
