#include "apps/view/panels.h"

#include <imgui.h>

#include <algorithm>

namespace manylight {
namespace {

void drawChoice(const SettingHelp& help, const std::string& label, const Json& value, const std::string& command,
                PanelAnswer& answer) {
    const std::string current = value.get<std::string>();
    if (!ImGui::BeginCombo(label.c_str(), current.c_str())) return;
    for (const std::string& choice : help.choices())
        if (ImGui::Selectable(choice.c_str(), choice == current)) answer.commands.push_back(command + choice);
    ImGui::EndCombo();
}

/// Most ranges span decades, but those around zero and those of time are even.
ImGuiSliderFlags flagsOf(const SettingHelp& help) {
    const bool isTime = help.values == std::string_view("SECONDS");
    return !isTime && help.sliderLow >= 0.0 && help.sliderHigh > 50.0 ? ImGuiSliderFlags_Logarithmic
                                                                      : ImGuiSliderFlags_None;
}

void drawWhole(const SettingHelp& help, const std::string& label, const Json& value, const std::string& command,
               PanelAnswer& answer) {
    int64_t number = value.is_null() ? static_cast<int64_t>(help.sliderLow) : value.get<int64_t>();
    bool isChanged = false;
    if (help.sliderHigh > help.sliderLow) {
        const auto low = static_cast<int64_t>(help.sliderLow);
        const auto high = static_cast<int64_t>(help.sliderHigh);
        isChanged = ImGui::SliderScalar(label.c_str(), ImGuiDataType_S64, &number, &low, &high, "%lld", flagsOf(help));
        answer.isDragging |= isChanged && ImGui::IsItemActive();
    } else {
        const int64_t step = 1;
        isChanged = ImGui::InputScalar(label.c_str(), ImGuiDataType_S64, &number, &step, nullptr, "%lld",
                                       ImGuiInputTextFlags_EnterReturnsTrue);
    }
    if (isChanged) answer.commands.push_back(command + std::to_string(number));
}

void drawNumber(const SettingHelp& help, const std::string& label, const Json& value, const std::string& command,
                PanelAnswer& answer) {
    double number = value.get<double>();
    const bool isChanged = ImGui::SliderScalar(label.c_str(), ImGuiDataType_Double, &number, &help.sliderLow,
                                               &help.sliderHigh, "%.3g", flagsOf(help));
    answer.isDragging |= isChanged && ImGui::IsItemActive();
    if (isChanged) answer.commands.push_back(fmt::format("{}{:.6g}", command, number));
}

}  // namespace

void drawSetting(const SettingHelp& help, const Json& value, const std::string& prefix, PanelAnswer& answer) {
    const std::string command = fmt::format("set {}{} ", prefix, help.option);
    const std::string label = fmt::format("{}##{}{}", help.option, prefix, help.option);
    if (help.isSwitch()) {
        bool isOn = value.get<bool>();
        if (ImGui::Checkbox(label.c_str(), &isOn)) answer.commands.push_back(command + (isOn ? "on" : "off"));
    } else if (!help.choices().empty()) {
        drawChoice(help, label, value, command, answer);
    } else if (value.is_number_float()) {
        drawNumber(help, label, value, command, answer);
    } else {
        drawWhole(help, label, value, command, answer);
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help.help);
}

}  // namespace manylight
