#include "apps/view_model/view_settings.h"

#include "engine/core/error.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <functional>

namespace manylight {
namespace {

struct Setting {
    SettingHelp help;
    std::function<void(ViewSettings&, const SettingHelp&, const std::string& value)> apply;
    std::function<Json(const ViewSettings&)> read;
};

/// Place of the value among what the description lists.
size_t choiceOf(const SettingHelp& help, const std::string& value) {
    std::vector<std::string> names = help.choices();
    if (help.isSwitch()) names = {"off", "on"};
    const auto found = std::find(names.begin(), names.end(), value);
    if (found == names.end()) failUsage("--{} {}: expected one of {}", help.option, value, fmt::join(names, ", "));
    return static_cast<size_t>(found - names.begin());
}

double numberOf(const SettingHelp& help, const std::string& value) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc{} || end != value.data() + value.size() || !(number >= help.sliderLow) ||
        !(number <= help.sliderHigh))
        failUsage("--{} {}: expected a number from {} to {}", help.option, value, help.sliderLow, help.sliderHigh);
    return number;
}

template <bool ViewSettings::*member>
Setting switchSetting(const char* option, const char* help) {
    return {{option, "on|off", help},
            [](ViewSettings& s, const SettingHelp& h, const std::string& v) { s.*member = choiceOf(h, v) == 1; },
            [](const ViewSettings& s) -> Json { return s.*member; }};
}

template <auto member>
Setting numberSetting(const char* option, const char* values, const char* help, double low, double high) {
    return {{option, values, help, low, high},
            [](ViewSettings& s, const SettingHelp& h, const std::string& v) {
                s.*member = static_cast<std::remove_reference_t<decltype(s.*member)>>(numberOf(h, v));
            },
            [](const ViewSettings& s) -> Json { return s.*member; }};
}

template <auto member>
Setting choiceSetting(const char* option, const char* values, const char* help) {
    const SettingHelp description{option, values, help};
    return {description,
            [](ViewSettings& s, const SettingHelp& h, const std::string& v) {
                s.*member = static_cast<std::remove_reference_t<decltype(s.*member)>>(choiceOf(h, v));
            },
            [names = description.choices()](const ViewSettings& s) -> Json {
                return names[static_cast<size_t>(s.*member)];
            }};
}

const std::vector<Setting>& settingTable() {
    using S = ViewSettings;
    static const std::vector<Setting> table = {
        switchSetting<&S::panel>("panel", "the panels"),
        switchSetting<&S::timings>("timings", "the panel of times"),
        switchSetting<&S::help>("keys", "the list of keys"),
        numberSetting<&S::panelScale>("panel-scale", "X", "size of text and panels (0: as the screen asks for)", 0, 4),
        choiceSetting<&S::navigation>("navigation", "fly|orbit", "what mouse and keys do to the camera"),
        numberSetting<&S::budget>("budget", "MS", "milliseconds a frame may take while something moves (0: any)", 0,
                                  2000),
        numberSetting<&S::pixelScale>("pixel-scale", "X", "pixels rendered per pixel of the window", 0.125, 2),
        numberSetting<&S::frameLimit>("frame-limit", "N", "a still picture is done after N frames", 1, 1 << 24),
        choiceSetting<&S::compare>("compare", "off|split|difference", "with the other side"),
        numberSetting<&S::divider>("divider", "X", "where the other side begins, as a share of the width", 0, 1),
        switchSetting<&S::plays>("play", "the scene's animation goes on"),
        numberSetting<&S::at>("at", "SECONDS", "the scene's animation so many seconds after its start", 0, 1e9),
        numberSetting<&S::speed>("speed", "X", "seconds of the animation in a second", 0, 10),
        switchSetting<&S::loops>("loop", "behind its end the animation begins again"),
    };
    return table;
}

const Setting* find(const std::string& option) {
    for (const Setting& setting : settingTable())
        if (option == setting.help.option) return &setting;
    return nullptr;
}

}  // namespace

const std::vector<SettingHelp>& viewSettingHelps() {
    static const std::vector<SettingHelp> helps = [] {
        std::vector<SettingHelp> list;
        for (const Setting& setting : settingTable()) list.push_back(setting.help);
        return list;
    }();
    return helps;
}

bool isViewSetting(const std::string& option) { return find(option) != nullptr; }

bool isPlaybackSetting(const std::string& option) {
    return option == "play" || option == "at" || option == "speed" || option == "loop";
}

void applyViewSetting(ViewSettings& settings, const std::string& option, const std::string& value) {
    const Setting* setting = find(option);
    if (setting == nullptr) failUsage("--{}: no such setting", option);
    setting->apply(settings, setting->help, value);
}

Json viewSettingValue(const ViewSettings& settings, const std::string& option) {
    const Setting* setting = find(option);
    if (setting == nullptr) failUsage("--{}: no such setting", option);
    return setting->read(settings);
}

std::string nextChoice(const SettingHelp& help, const Json& value) {
    if (help.isSwitch()) return value.get<bool>() ? "off" : "on";
    const std::vector<std::string> names = help.choices();
    if (names.empty()) return {};
    const auto found = std::find(names.begin(), names.end(), value.get<std::string>());
    return found == names.end() || found + 1 == names.end() ? names.front() : *(found + 1);
}

std::string settingText(const Json& value) {
    if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
    return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace manylight
