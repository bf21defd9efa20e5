// What the window shows is what is rendered without one.
#include "tests/view/view_test.h"

#include "engine/techniques/renderer.h"

#include <gmock/gmock.h>

namespace manylight::test {
namespace {

using ::testing::HasSubstr;
using ViewerPictures = ViewerTest;

struct Case {
    const char* name;
    std::vector<std::pair<const char*, const char*>> settings;  // on top of those before
};

const std::vector<Case>& cases() {
    static const std::vector<Case> list = {
        {"deferred", {}},
        {"local", {{"lighting", "local"}}},
        {"global", {{"lighting", "global"}}},
        {"forward", {{"lighting", "both"}, {"technique", "forward"}}},
        {"prepass", {{"technique", "forward-prepass"}, {"clamp", "compensate"}}},
        {"paths", {{"technique", "path-tracer"}}},
        {"vpls", {{"technique", "deferred"}, {"clamp", "bound"}, {"show", "vpls"}}},
        {"normal", {{"show", "normal"}}},
        {"depth", {{"show", "depth"}}},
        {"material", {{"show", "material"}}},
        {"cut-off", {{"show", "cut-off"}, {"exposure", "6"}}},
        {"rays", {{"show", "rays"}, {"exposure", "0"}}},
        {"display", {{"show", "picture"}, {"exposure", "1.5"}, {"tone-map", "reinhard"}}},
    };
    return list;
}

TEST_F(ViewerPictures, OfEveryTechniqueAndViewAreThoseOfTheRenderer) {
    std::string script = "set panel off\n";
    for (const Case& one : cases()) {
        for (const auto& [option, value] : one.settings) script += fmt::format("set {} {}\n", option, value);
        script += fmt::format("frames 2\nscreenshot {}.png\n", one.name);
    }
    view(script, "--vpls 12");

    gpu::Device device;
    const Scene scene = importScene(std::string(MANYLIGHT_SOURCE_DIR) + "/scenes/cornell_box.json");
    RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.vplCount = 12;
    settings.bounceCount = 2;
    settings.lightSampleCount = 4;
    settings.jitter = true;
    Renderer renderer(device, scene, settings);
    for (const Case& one : cases()) {
        for (const auto& [option, value] : one.settings) applySetting(settings, option, value);
        renderer.restart(settings);
        for (int frame = 0; frame < 2; ++frame) renderer.renderFrame();
        const EncodedImage expected{kWidth, kHeight, renderer.displayRgba()};
        EXPECT_EQ(largestDifference(imageOf(std::string(one.name) + ".png"), expected), 0) << one.name;
    }
}

TEST_F(ViewerPictures, OfASavedViewAreTheSameWithoutAWindow) {
    view(
        "set panel off\nkey w 4\ndrag left 9 4 3\nreport moving.json\nset clamp bound\nadd-light point\n"
        "light 0 brightness 0.5\nframes 2\ncapture seen.png\nsave-view view.json",
        "--vpls 12 --budget 1");
    EXPECT_EQ(jsonOf("moving.json")["moving"], true);
    EXPECT_LT(jsonOf("moving.json")["quality"]["scale"], 1.0) << "smaller while it moves";
    EXPECT_EQ(jsonOf("end.json")["quality"]["scale"], 1.0);
    ASSERT_EQ(run(program("capture") + " view.json --frames 2 -o headless.png"), 0) << textOf("output");
    EXPECT_EQ(largestDifference(imageOf("seen.png"), imageOf("headless.png")), 0);
}

TEST_F(ViewerPictures, SplitAndDifferenceShowBothSides) {
    view(
        "set panel off\nset other.technique deferred\nset other.vpls 3\nset compare split\nset divider 0.25\nframes 2\n"
        "screenshot split.png\nset divider 0\nscreenshot other.png\nset compare off\nframes 2\n"
        "screenshot main.png\nset other.vpls 12\nset compare difference\nframes 2\nreport same.json\n"
        "set other.vpls 3\nframes 2\nreport differs.json",
        "--vpls 12");
    const EncodedImage split = imageOf("split.png");
    const EncodedImage main = imageOf("main.png");
    const EncodedImage other = imageOf("other.png");
    EXPECT_GT(largestDifference(main, other), 10);
    for (size_t y = 0; y < kHeight; ++y)
        for (size_t x = 0; x < kWidth; ++x) {
            if (x + 3 > kWidth / 4 && x < kWidth / 4 + 3) continue;  // the divider itself
            if (x < 3) continue;                                     // that of the other picture
            const EncodedImage& expected = x < kWidth / 4 ? main : other;
            const size_t pixel = (y * kWidth + x) * 4;
            ASSERT_EQ(split.rgba[pixel], expected.rgba[pixel]) << x << ", " << y;
        }
    EXPECT_EQ(jsonOf("same.json")["rmse"], 0.0);
    EXPECT_EQ(jsonOf("same.json")["flip"], 0.0);
    EXPECT_GT(jsonOf("differs.json")["rmse"], 0.0);
    EXPECT_GT(jsonOf("differs.json")["flip"], 0.0);
}

}  // namespace
}  // namespace manylight::test
