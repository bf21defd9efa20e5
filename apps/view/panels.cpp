#include "apps/view/panels.h"

#include "apps/view_model/key_bindings.h"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace manylight {
namespace {

/// Pairs of lighting and show that people switch between.
struct NamedView {
    const char* name;
    const char* lighting;
    const char* show;
};
constexpr std::array kViews = {NamedView{"both", "both", "picture"},      NamedView{"local", "local", "picture"},
                               NamedView{"global", "global", "picture"},  NamedView{"VPLs", "both", "vpls"},
                               NamedView{"normal", "both", "normal"},     NamedView{"albedo", "both", "albedo"},
                               NamedView{"depth", "both", "depth"},       NamedView{"position", "both", "position"},
                               NamedView{"material", "both", "material"}, NamedView{"cut off", "both", "cut-off"},
                               NamedView{"rays", "both", "rays"}};

void drawViews(const PanelView& view, PanelAnswer& answer) {
    const RenderSettings& settings = view.main.settings;
    for (size_t i = 0; i < kViews.size(); ++i) {
        const NamedView& named = kViews[i];
        if (i % 4 != 0) ImGui::SameLine();
        const bool isCurrent =
            named.show == std::string(name(settings.show)) &&
            (settings.show != Show::Picture || named.lighting == std::string(name(settings.lighting)));
        if (isCurrent) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        if (ImGui::SmallButton(named.name)) {
            answer.commands.push_back(fmt::format("set lighting {}", named.lighting));
            answer.commands.push_back(fmt::format("set show {}", named.show));
        }
        if (isCurrent) ImGui::PopStyleColor();
    }
}

void drawRenderSettings(const RenderSettings& settings, const RenderSettings& resolved, const std::string& prefix,
                        PanelAnswer& answer) {
    for (const SettingHelp& help : settingHelps()) {
        const std::string option = help.option;
        if (option == "size") continue;                       // the window's
        if (option == "plan-keeps") continue;                 // for measuring; "Left out" shows what it would name
        if (!prefix.empty() && option == "camera") continue;  // both look through one
        Json value = settingValue(settings, option);
        if (value.is_null()) value = settingValue(resolved, option);
        drawSetting(help, value, prefix, answer);
    }
}

/// Those of the animation, or all others.
void drawViewSettings(const PanelView& view, bool playback, PanelAnswer& answer) {
    for (SettingHelp help : viewSettingHelps()) {
        if (isPlaybackSetting(help.option) != playback) continue;
        if (help.option == std::string("at")) help.sliderHigh = view.state.animationEnd;
        drawSetting(help, viewSettingValue(view.state.view, help.option), "", answer);
    }
}

void drawState(const PanelView& view, PanelAnswer& answer) {
    const ViewState& state = view.state;
    const ShownNumbers& shown = state.shown;
    ImGui::Text("%s", state.scene->name.c_str());
    ImGui::Text("%ux%u, %u VPLs, frame %u", shown.size.x, shown.size.y, shown.vplCount, shown.frames);
    const double milliseconds = shown.times.medianTotal();
    ImGui::Text("%.1f ms, %.1f FPS%s", milliseconds, milliseconds > 0.0 ? 1000.0 / milliseconds : 0.0,
                shown.isMoving ? " (moving)" : "");
    if (ImGui::SmallButton(view.fps.isRunning() ? "stop measuring" : "measure FPS"))
        answer.commands.emplace_back("fps-table");
    if (shown.quality != FrameQuality{})
        ImGui::Text("budget %.0f ms: %.0f %% of the size, %.1f %% of the VPLs", state.view.budget,
                    100.0 * shown.quality.scale, 100.0 * shown.quality.vpls);
}

void drawCamera(const PanelView& view, PanelAnswer& answer) {
    const ViewState& state = view.state;
    const CameraPose& pose = state.shown.pose;
    ImGui::Text("at %.4g %.4g %.4g", pose.origin.x, pose.origin.y, pose.origin.z);
    ImGui::Text("to %.4g %.4g %.4g", pose.target.x, pose.target.y, pose.target.z);
    ImGui::Text("speed %.3g a second", state.shown.speed);
    for (size_t i = 0; i < state.scene->cameras.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        const std::string& given = state.scene->cameras[i].name;
        if (ImGui::SmallButton(fmt::format("{}##camera{}", given.empty() ? std::to_string(i) : given, i).c_str()))
            answer.commands.push_back(fmt::format("camera {}", i));
    }
    if (ImGui::SmallButton("copy view")) answer.commands.emplace_back("copy-view");
    ImGui::SameLine();
    if (ImGui::SmallButton("save view")) answer.commands.emplace_back("save-view");
    ImGui::SameLine();
    if (ImGui::SmallButton("save picture")) answer.commands.emplace_back("capture");
}

void drawComparison(const PanelView& view, PanelAnswer& answer) {
    const ViewState& state = view.state;
    if (const auto& report = view.comparison.report()) {
        ImGui::Text("RMSE %.5g, mean %.5g", report->rmse, report->meanLuminanceReference);
        if (report->relativeMse) ImGui::Text("relative MSE %.5g", *report->relativeMse);
        if (report->smape) ImGui::Text("SMAPE %.4f", *report->smape);
        if (view.comparison.flip()) ImGui::Text("FLIP %.4f", *view.comparison.flip());
    }
    if (view.hasReference && state.view.compare == Compare::Difference) {
        ImGui::TextUnformatted("against the reference file");
        return;
    }
    ImGui::Text("the other side, frame %u:", view.other.frameCount());
    if (view.other.exists())
        drawRenderSettings(view.other.settings, view.other.renderer().settings(), "other.", answer);
}

void drawMain(const PanelView& view, PanelAnswer& answer) {
    const float scale = panelScale();
    ImGui::SetNextWindowPos({8 * scale, 8 * scale}, placeWhen(view));
    ImGui::SetNextWindowSize({300 * scale, 0.85f * ImGui::GetIO().DisplaySize.y}, placeWhen(view));
    if (ImGui::Begin("Manylight")) {
        ImGui::PushItemWidth(120 * scale);
        drawState(view, answer);
        drawViews(view, answer);
        if (view.state.animationEnd > 0.0 && ImGui::CollapsingHeader("Animation", ImGuiTreeNodeFlags_DefaultOpen))
            drawViewSettings(view, true, answer);
        if (ImGui::CollapsingHeader("Rendering", ImGuiTreeNodeFlags_DefaultOpen))
            drawRenderSettings(view.main.settings, view.main.renderer().settings(), "", answer);
        if (ImGui::CollapsingHeader("Window")) drawViewSettings(view, false, answer);
        if (ImGui::CollapsingHeader("Camera")) drawCamera(view, answer);
        if (ImGui::CollapsingHeader("Lights")) drawLights(view, answer);
        if (view.state.view.compare != Compare::Off &&
            ImGui::CollapsingHeader("Comparison", ImGuiTreeNodeFlags_DefaultOpen))
            drawComparison(view, answer);
        if (ImGui::CollapsingHeader("Left out")) drawPlan(view);
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

void drawMessage(const PanelView& view) {
    std::string text = view.state.messageSeconds > 0.0 ? view.state.message : "";
    if (!view.state.shaderProblem.empty()) text = view.state.shaderProblem + (text.empty() ? "" : "\n") + text;
    if (text.empty()) return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x / 2, window.y - 8.0f}, ImGuiCond_Always, {0.5f, 1.0f});
    ImGui::SetNextWindowSize({0.9f * window.x, 0.0f});
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    ImGui::Begin("message", nullptr, kFlags);
    const bool isProblem = view.state.isError || !view.state.shaderProblem.empty();
    if (isProblem) ImGui::PushStyleColor(ImGuiCol_Text, {1.0f, 0.6f, 0.5f, 1.0f});
    ImGui::TextWrapped("%s", text.c_str());
    if (isProblem) ImGui::PopStyleColor();
    ImGui::End();
}

void drawDivider(const PanelView& view) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float x = static_cast<float>(view.state.view.divider) * window.x;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddLine({x, 0}, {x, window.y}, IM_COL32(255, 255, 255, 200), 2.0f * panelScale());
    if (!view.state.view.panel) return;
    const auto label = [&](const RenderSettings& s) {
        return fmt::format("{}, {} VPLs", name(s.technique), s.vplCount);
    };
    const std::string right = label(view.other.settings);
    const std::string left = label(view.main.settings);
    const float y = window.y - 2.0f * ImGui::GetFontSize();
    list.AddText({x + 6.0f, y}, IM_COL32_WHITE, right.c_str());
    list.AddText({x - 6.0f - ImGui::CalcTextSize(left.c_str()).x, y}, IM_COL32_WHITE, left.c_str());
}

}  // namespace

int placeWhen(const PanelView& view) { return view.isRescaled ? ImGuiCond_Always : ImGuiCond_FirstUseEver; }
float panelScale() { return ImGui::GetFontSize() / 13.0f; }

void drawKeys(const PanelView& view) {
    ImGui::SetNextWindowPos({ImGui::GetIO().DisplaySize.x / 2, 8.0f}, placeWhen(view), {0.5f, 0.0f});
    ImGui::Begin("Keys", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
    if (ImGui::BeginTable("keys", 2)) {
        const auto row = [](const char* key, const char* help) {
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(key);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(help);
        };
        for (const KeyBinding& binding : keyBindings()) row(binding.key, binding.help);
        row("left mouse", "turn, or orbit; drags the divider and lights");
        row("right mouse", "shift the view");
        row("wheel", "speed, or distance");
        ImGui::EndTable();
    }
    ImGui::End();
}

PanelAnswer drawPanels(const PanelView& view) {
    PanelAnswer answer;
    const ViewSettings& settings = view.state.view;
    if (settings.compare == Compare::Split && view.other.exists()) drawDivider(view);
    if (settings.panel) {
        drawLightHandles(view, answer);
        drawMain(view, answer);
        if (settings.timings) drawTimings(view, answer);
        if (!view.fps.cells().empty()) drawFps(view, answer);
        drawMessage(view);
    }
    if (settings.help) drawKeys(view);
    return answer;
}

}  // namespace manylight
