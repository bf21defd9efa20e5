// What may happen to a window, and what it must survive.
#include "tests/view/view_test.h"

#include <gmock/gmock.h>

#include <thread>

namespace manylight::test {
namespace {

using ::testing::HasSubstr;
class ViewerWindow : public ViewerTest {
  protected:
    /// The last column and the last row in which two screenshots of one size differ below row `top`; -1 if they do not.
    glm::ivec2 lastDifferent(const char* one, const char* other, uint32_t top) const {
        const EncodedImage a = imageOf(one);
        const EncodedImage b = imageOf(other);
        EXPECT_EQ(a.rgba.size(), b.rgba.size());
        glm::ivec2 last(-1);
        for (size_t i = size_t{4} * a.width * top; i < std::min(a.rgba.size(), b.rgba.size()); ++i)
            if (a.rgba[i] != b.rgba[i]) last = glm::max(last, glm::ivec2(i / 4 % a.width, i / 4 / a.width));
        return last;
    }
};

TEST_F(ViewerWindow, FollowsItsSizeAndShowsItsPanels) {
    view(
        "set panel off\nframes 1\nresize 130 70\nframes 2\nscreenshot large.png\nreport large.json\nresize 64 48\n"
        "frames 1\nscreenshot small.png\nresize 300 200\nset panel on\nset keys on\nframes 1\nwait 2\nscreenshot "
        "panels.png\n"
        "key tab\nkey f1\nwait 1\nscreenshot plain.png\ncapture plain_too.png",
        "--vpls 4");
    EXPECT_EQ(imageOf("large.png").width, 130u);
    EXPECT_EQ(imageOf("large.png").height, 70u);
    EXPECT_EQ(jsonOf("large.json")["settings"]["size"], "130x70");
    EXPECT_EQ(imageOf("small.png").width, 64u);
    EXPECT_GT(largestDifference(imageOf("panels.png"), imageOf("plain.png")), 50);
}

TEST_F(ViewerWindow, PanelsAreShownToTheirEdges) {
    view("resize 512 384\nset panel on\nframes 1\nscreenshot panels.png\nset panel off\nframes 1\nscreenshot plain.png",
         "--vpls 4");
    // Below the title of "Times" there are the settings alone: 300 columns from 8 on, and 0.85 of the rows. The border
    // shows.
    const glm::ivec2 last = lastDifferent("panels.png", "plain.png", 64);
    EXPECT_NEAR(last.x, 8 + 300 - 1, 1);
    EXPECT_NEAR(last.y, 8 + 0.85 * 384 - 1, 1);
}

TEST_F(ViewerWindow, KeepsTheSceneIfAnotherIsBroken) {
    write("broken.gltf", "{\"asset\": 3");
    write("good.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
    write("room.json", R"({"scene": "good.obj", "name": "dropped room"})");
    view(
        "set panel off\nframes 1\nopen broken.gltf\nwait 1\nreport broken.json\nopen missing.json\nwait 1\nreport "
        "missing.json\n"
        "set vpls many\nreport setting.json\nset technique forward\nset show cut-off\nwait 2\nreport refused.json\n"
        "open good.obj\nframes 1\nreport good.json\nscreenshot good.png\ndrop broken.gltf\nreport dropped.json\n"
        "frames 1\nscreenshot kept.png\ndrop room.json\nframes 1",
        "--vpls 4");
    EXPECT_EQ(jsonOf("broken.json")["scene"], "cornell_box");
    EXPECT_THAT(jsonOf("broken.json")["message"].get<std::string>(), HasSubstr("broken.gltf"));
    EXPECT_THAT(jsonOf("missing.json")["message"].get<std::string>(), HasSubstr("missing.json"));
    EXPECT_THAT(jsonOf("setting.json")["message"].get<std::string>(),
                HasSubstr("--vpls many: expected a whole number"));
    EXPECT_EQ(jsonOf("refused.json")["settings"]["show"], "picture") << "what does not fit is taken back";
    EXPECT_THAT(jsonOf("refused.json")["message"].get<std::string>(), HasSubstr("--technique deferred only"));
    EXPECT_EQ(jsonOf("good.json")["scene"], "good");
    EXPECT_EQ(jsonOf("dropped.json")["is_error"], true);
    EXPECT_THAT(jsonOf("dropped.json")["message"].get<std::string>(), HasSubstr("broken.gltf"));
    EXPECT_EQ(largestDifference(imageOf("good.png"), imageOf("kept.png")), 0);
    EXPECT_EQ(jsonOf("end.json")["scene"], "dropped room");
}

TEST_F(ViewerWindow, TakesUpShadersThatChangeAndKeepsThoseThatWorked) {
    // A slow compiler: frames go on meanwhile.
    write("slow/glslangValidator", "#!/bin/sh\nsleep 0.3\nPATH=${PATH#*:}\nexec glslangValidator \"$@\"\n");
    std::filesystem::permissions(folder_ / "slow/glslangValidator", std::filesystem::perms::all);
    environment_ = fmt::format("PATH='{}/slow':$PATH", folder_.string());
    const std::filesystem::path source = std::string(MANYLIGHT_SOURCE_DIR) + "/shaders";
    std::filesystem::copy(source, folder_ / "shaders", std::filesystem::copy_options::recursive);
    const std::string tonemap = readTextFile(source / "passes" / "tonemap.comp");
    const std::string last = "imageStore(display, pixel, ";
    const size_t at = tonemap.rfind(last);
    ASSERT_NE(at, std::string::npos);
    const std::string head = tonemap.substr(0, at);

    std::thread developer([&] {
        const auto await = [&](const char* name) {
            for (int i = 0; i < 6000 && !std::filesystem::exists(folder_ / name); ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
        };
        await("started.json");
        write("shaders/passes/tonemap.comp", head + last + "vec4(1.0, 0.0, 1.0, 1.0));\n}\n");
        write("changed", "");
        await("magenta.png");
        write("shaders/passes/tonemap.comp", head + "oops;\n}\n");
        write("broken", "");
    });
    view(
        "set panel off\nframes 1\nreport started.json\nwait-for changed\nreport changed.json\nwatch\nreport "
        "taken.json\nframes 1\nscreenshot magenta.png\n"
        "wait-for broken\nwatch\nwait 1\nreport broken.json\nscreenshot still.png",
        "--vpls 4 --watch-shaders .");
    developer.join();
    EXPECT_GE(jsonOf("taken.json")["frames_presented"].get<int>(),
              jsonOf("changed.json")["frames_presented"].get<int>() + 5);
    EXPECT_EQ(jsonOf("taken.json")["message"], "tonemap.comp is new");
    const EncodedImage magenta = imageOf("magenta.png");
    for (size_t i = 0; i < magenta.rgba.size(); i += 4)
        ASSERT_TRUE(magenta.rgba[i] == 255 && magenta.rgba[i + 1] == 0 && magenta.rgba[i + 2] == 255) << i / 4;
    EXPECT_THAT(jsonOf("broken.json")["shader_problem"].get<std::string>(), HasSubstr("tonemap.comp:"));
    EXPECT_THAT(jsonOf("broken.json")["shader_problem"].get<std::string>(), HasSubstr("oops"));
    EXPECT_EQ(largestDifference(imageOf("still.png"), magenta), 0);
}

TEST_F(ViewerWindow, WithoutADisplayItSaysSoAndNamesTheOtherProgram) {
    const std::string command = fmt::format("env -u WAYLAND_DISPLAY DISPLAY= {} {}/scenes/cornell_box.json",
                                            program("view"), MANYLIGHT_SOURCE_DIR);
    EXPECT_EQ(run(command), 1);
    const std::string output = textOf("output");
    EXPECT_THAT(output, HasSubstr("no display"));
    EXPECT_THAT(output, HasSubstr("manylight-capture"));
    EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << "one line";
}

}  // namespace
}  // namespace manylight::test
