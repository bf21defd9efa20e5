// What a user does to a window, and what it costs.
#include "tests/view/view_test.h"

#include <gmock/gmock.h>

namespace manylight::test {
namespace {

using ::testing::HasSubstr;
using ViewerInteraction = ViewerTest;

TEST_F(ViewerInteraction, AMinimisedWindowRendersNothingAndRests) {
    view(
        "set panel off\nframes 1\nscreenshot before.png\niconify\nwait 1\nreport down.json\nset vpls 5\nkey w 3\nwait "
        "6\n"
        "frames 2\nreport still_down.json\nsave-view small.json\nrestore\nset vpls 4\nreset-view\nframes 1\n"
        "screenshot after.png",
        "--vpls 4");
    const Json down = jsonOf("down.json");
    const Json stillDown = jsonOf("still_down.json");
    EXPECT_EQ(down["minimised"], true);
    EXPECT_EQ(stillDown["frames_presented"], down["frames_presented"]);
    EXPECT_EQ(stillDown["frames"], down["frames"]);
    EXPECT_GT(stillDown["seconds"].get<double>() - down["seconds"].get<double>(), 0.2) << "11 rounds, none in a hurry";
    EXPECT_THAT(stillDown["message"].get<std::string>(), HasSubstr("expected 'restore' before"));
    EXPECT_EQ(jsonOf("small.json")["camera"]["width"], kWidth);
    EXPECT_EQ(jsonOf("end.json")["minimised"], false);
    EXPECT_GT(jsonOf("end.json")["frames_presented"], stillDown["frames_presented"]);
    EXPECT_EQ(largestDifference(imageOf("before.png"), imageOf("after.png")), 0);
}

/// Columns of the picture in which the panel's background covers it, on a row in the middle.
int darkColumns(const EncodedImage& with, const EncodedImage& without) {
    int columns = 0;
    for (uint32_t x = 0; x < with.width; ++x) {
        const size_t pixel = (size_t{with.height / 2} * with.width + x) * 4;
        columns += with.rgba[pixel] != without.rgba[pixel] ? 1 : 0;
    }
    return columns;
}

TEST_F(ViewerInteraction, PanelsFollowTheScaleOfTheScreen) {
    view(
        "resize 640 120\nset timings off\nset show normal\nframes 1\nwait 2\nscreenshot one.png\nreport one.json\nwait "
        "16\nreport later.json\nset panel-scale 2\n"
        "wait 3\nscreenshot two.png\nreport two.json\nset panel-scale 0\nwait 3\nscreenshot again.png\nset panel off\n"
        "wait 2\nscreenshot none.png",
        "--vpls 4 --frame-limit 1");
    EXPECT_EQ(jsonOf("one.json")["panel"]["scale"], 1.0);
    EXPECT_EQ(jsonOf("two.json")["panel"]["scale"], 2.0);
    const EncodedImage none = imageOf("none.png");
    EXPECT_NEAR(darkColumns(imageOf("one.png"), none), 300, 20);
    EXPECT_NEAR(darkColumns(imageOf("two.png"), none), 600, 40);
    EXPECT_NEAR(darkColumns(imageOf("again.png"), none), 300, 20);
    const size_t margin = (size_t{60} * none.width + 12) * 4;  // of the panel, between its border and its content
    EXPECT_NEAR(imageOf("one.png").rgba[margin], 0.15 * none.rgba[margin] + 0.85 * 0.06 * 255, 2.0);
    EXPECT_GT(jsonOf("one.json")["panel"]["cpu_milliseconds"], 0.0);
    EXPECT_GT(jsonOf("one.json")["panel"]["gpu_milliseconds"], 0.0);
    EXPECT_GE(jsonOf("later.json")["frames_presented"].get<int>(),
              jsonOf("one.json")["frames_presented"].get<int>() + 16);
    EXPECT_LE(jsonOf("later.json")["panel"]["drawn"].get<int>(), jsonOf("one.json")["panel"]["drawn"].get<int>() + 5)
        << "what does not change is not drawn again";
}

TEST_F(ViewerInteraction, ThePictureFollowsTheMouseWithinTwoFrames) {
    view(
        "set panel off\nframes 1\ncapture before.png\nset budget 0\nlatency 8\nreport full.json\nset budget 20\n"
        "latency 8\nreport budget.json\nframes 1\ncapture after.png",
        "--vpls 4 --temporal off");
    for (const char* name : {"full.json", "budget.json"}) {
        const Json latency = jsonOf(name)["latency"];
        EXPECT_EQ(latency["inputs"], 8);
        EXPECT_GT(latency["frames_median"], 1.0) << name;
        EXPECT_LT(latency["frames_most"], 2.0) << name;
        EXPECT_GT(latency["milliseconds_median"], 0.0) << name;
    }
    EXPECT_EQ(jsonOf("full.json")["quality"]["scale"], 1.0) << "measured at the full size";
    EXPECT_EQ(largestDifference(imageOf("before.png"), imageOf("after.png")), 0) << "the view is as it was";
}

TEST_F(ViewerInteraction, EmissionIsScaledSavedAndTakenBack) {
    view(
        "set panel off\nframes 2\ncapture before.png\nemission 0 0.25\nframes 2\ncapture dim.png\n"
        "save-view dim.json\nemission 9 1\nreport wrong.json\nadd-light point\nundo\nundo\nframes 2\n"
        "capture after.png\nundo\nreport empty.json\nsave-view plain.json",
        "--vpls 12");
    EXPECT_GT(largestDifference(imageOf("before.png"), imageOf("dim.png")), 20);
    ASSERT_EQ(run(program("capture") + " dim.json --frames 2 -o headless.png"), 0) << textOf("output");
    EXPECT_EQ(largestDifference(imageOf("dim.png"), imageOf("headless.png")), 0);
    EXPECT_THAT(jsonOf("wrong.json")["message"].get<std::string>(), HasSubstr("expected a whole number from 0 to 0"));
    EXPECT_EQ(largestDifference(imageOf("before.png"), imageOf("after.png")), 0);
    EXPECT_THAT(jsonOf("empty.json")["message"].get<std::string>(), HasSubstr("no light was changed"));
    EXPECT_FALSE(jsonOf("plain.json").contains("emission"));
}

}  // namespace
}  // namespace manylight::test
