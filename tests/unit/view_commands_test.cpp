#include "apps/view_model/key_bindings.h"
#include "apps/view_model/playable_scene.h"
#include "apps/view_model/script.h"
#include "apps/view_model/shader_reloader.h"
#include "apps/view_model/view_settings.h"
#include "engine/core/file.h"
#include "tests/unit/import_test_support.h"

#include <gmock/gmock.h>

#include <set>
#include <thread>

namespace manylight {
namespace {

using ::testing::HasSubstr;

std::string messageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Script, IsWordsAndCommentsAndKeepsQuotedSpaces) {
    const auto commands = parseScript("# nothing\n\n  set vpls 100  # few\nopen \"a b.json\"\r\nquit", "tour.txt");
    ASSERT_EQ(commands.size(), 3u);
    EXPECT_EQ(commands[0].words, (std::vector<std::string>{"set", "vpls", "100"}));
    EXPECT_EQ(commands[0].number(2), 100.0);
    EXPECT_EQ(commands[1].words, (std::vector<std::string>{"open", "a b.json"}));
    EXPECT_EQ(commands[2].place, "tour.txt: line 5");
}

TEST(Script, ErrorsNameFileLineAndWhatWasExpected) {
    const auto errorOf = [](const char* text) { return messageOf([&] { parseScript(text, "a.txt"); }); };
    EXPECT_THAT(errorOf("quit\njump 3\n"), HasSubstr("a.txt: line 2: unknown command 'jump', expected one of set,"));
    EXPECT_THAT(errorOf("set vpls"), HasSubstr("a.txt: line 1: set: expected NAME VALUE"));
    EXPECT_THAT(errorOf("quit now"), HasSubstr("a.txt: line 1: quit: expected no arguments"));
    EXPECT_THAT(errorOf("open \"a"), HasSubstr("expected a second quotation mark"));
    EXPECT_THAT(messageOf([] { parseScript("wait long", "a.txt").front().number(1); }),
                HasSubstr("a.txt: line 1: wait: expected a number, found 'long'"));
}

TEST(Keys, EachGivesACommandThatExists) {
    std::set<std::string> keys;
    for (const KeyBinding& binding : keyBindings()) {
        EXPECT_TRUE(keys.insert(binding.key).second) << binding.key << " is there twice";
        const std::string command = commandOfKey(binding.key);
        EXPECT_EQ(command, binding.command);
        if (command.empty()) continue;  // held down, it moves
        EXPECT_EQ(messageOf([&] { parseCommand(command, "key"); }), "no error") << command;
    }
    EXPECT_EQ(commandOfKey("no key"), "");
}

TEST(ViewSettings, EveryOneIsReadAsItIsWritten) {
    for (const SettingHelp& help : viewSettingHelps()) {
        ViewSettings settings;
        const std::string value = help.isSwitch() || !help.choices().empty()
                                      ? nextChoice(help, viewSettingValue(settings, help.option))
                                      : fmt::format("{}", help.sliderHigh);
        applyViewSetting(settings, help.option, value);
        EXPECT_EQ(settingText(viewSettingValue(settings, help.option)).substr(0, value.size()), value) << help.option;
        EXPECT_THAT(messageOf([&] { applyViewSetting(settings, help.option, "warp"); }),
                    HasSubstr(fmt::format("--{} warp: expected ", help.option)));
    }
}

TEST(Playing, BeginsAgainOrStopsAtTheEnd) {
    ViewSettings settings;
    playOn(settings, 2.0, 0.5);
    EXPECT_EQ(settings.at, 0.0) << "paused";
    settings.plays = true;
    settings.speed = 3.0;
    playOn(settings, 2.0, 0.5);
    EXPECT_EQ(settings.at, 1.5);
    playOn(settings, 2.0, 0.5);
    EXPECT_EQ(settings.at, 1.0);
    settings.loops = false;
    playOn(settings, 2.0, 0.5);
    EXPECT_EQ(settings.at, 2.0);
    EXPECT_FALSE(settings.plays);
}

TEST(Settings, EveryOneOfTheRenderersIsReadAsItIsWritten) {
    for (const SettingHelp& help : settingHelps()) {
        const Json before = settingValue({}, help.option);
        const std::string option = help.option;
        std::string value = option == "size" ? "5x7" : option == "camera" ? "3" : fmt::format("{}", help.sliderHigh);
        if (help.isSwitch() || !help.choices().empty()) value = nextChoice(help, before);
        RenderSettings settings;
        settings.width = settings.height = 1;  // nothing follows from a scene
        applySetting(settings, option, value);
        EXPECT_NE(settingValue(settings, option), before) << option;
        RenderSettings again;
        applySettings(again, toJson(settings), "here");
        EXPECT_EQ(settingValue(again, option), settingValue(settings, option)) << option;
    }
}

TEST(Settings, ChoicesAreThoseThatAreTaken) {
    for (const SettingHelp& help : settingHelps())
        for (const std::string& choice : help.choices()) {
            RenderSettings settings;
            applySetting(settings, help.option, choice);
            EXPECT_EQ(settingValue(settings, help.option), choice);
        }
}

using ShaderReload = testing::SceneFiles;

TEST_F(ShaderReload, CompilesWhatChangedOrIncludesItAndTellsWhereAnErrorIs) {
    const char* const header = "#define BRIGHT 1.0\n";
    const auto shader = [](const std::string& body) {
        return "#version 460\n#extension GL_GOOGLE_include_directive : require\n#include \"shaders/lib/a.glsl\"\n"
               "void main() { " +
               body + " }\n";
    };
    write("shaders/lib/a.glsl", header);
    write("shaders/passes/one.comp", shader("float x = BRIGHT;"));
    write("shaders/passes/two.comp", "#version 460\nvoid main() {}\n");
    ShaderReloader reloader(folder_);
    EXPECT_TRUE(reloader.compileChanged().empty());

    const auto touch = [&](const char* name, int seconds) {
        std::filesystem::last_write_time(
            folder_ / name, std::filesystem::last_write_time(folder_ / name) + std::chrono::seconds(seconds));
    };
    touch("shaders/lib/a.glsl", 1);
    std::vector<CompiledShader> compiled = reloader.compileChanged();
    ASSERT_EQ(compiled.size(), 1u);
    EXPECT_EQ(compiled[0].name, "one.comp");
    EXPECT_EQ(compiled[0].problem, "");
    ASSERT_FALSE(compiled[0].words.empty());
    EXPECT_EQ(compiled[0].words[0], 0x07230203u) << "SPIR-V's magic number";

    write("shaders/passes/one.comp", shader("float x = DARK;"));
    touch("shaders/passes/one.comp", 2);
    compiled = reloader.compileChanged();
    ASSERT_EQ(compiled.size(), 1u);
    EXPECT_THAT(compiled[0].problem, HasSubstr("one.comp:4:"));
    EXPECT_THAT(compiled[0].problem, HasSubstr("DARK"));
    EXPECT_TRUE(reloader.compileChanged().empty());
}

TEST_F(ShaderReload, CompilesOnAThreadOfItsOwn) {
    write("shaders/passes/two.comp", "#version 460\nvoid main() {}\n");
    ShaderReloader reloader(folder_);
    EXPECT_FALSE(reloader.take().has_value()) << "nothing was asked for";
    const std::filesystem::path file = folder_ / "shaders" / "passes" / "two.comp";
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(1));
    reloader.start();
    EXPECT_TRUE(reloader.isRunning());
    std::optional<std::vector<CompiledShader>> compiled;
    for (int i = 0; i < 3000 && !compiled; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        compiled = reloader.take();
    }
    ASSERT_TRUE(compiled.has_value());
    ASSERT_EQ(compiled->size(), 1u);
    EXPECT_EQ(compiled->front().name, "two.comp");
    EXPECT_FALSE(reloader.isRunning());
}

TEST_F(ShaderReload, NeedsASourceTree) {
    EXPECT_THAT(messageOf([&] { ShaderReloader reloader(folder_); }),
                HasSubstr("expected a folder that has shaders/passes"));
}

}  // namespace
}  // namespace manylight
