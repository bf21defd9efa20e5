#include "apps/view/panels.h"

#include "engine/core/statistics.h"

#include <imgui.h>

namespace manylight {
namespace {

constexpr size_t kColumns = 3;  // techniques of a VPL count

void textOrDash(double value, const char* format) {
    ImGui::TableNextColumn();
    if (value > 0.0)
        ImGui::Text(format, value);
    else
        ImGui::TextUnformatted("-");
}

double medianOf(const FpsSamples& samples) { return samples.wall.empty() ? 0.0 : median(samples.wall); }

void drawRow(const FpsSamples* cells) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::Text("%u", cells->cell.vplCount);
    for (size_t i = 0; i < kColumns; ++i) {
        const double milliseconds = medianOf(cells[i]);
        textOrDash(milliseconds > 0.0 ? 1000.0 / milliseconds : 0.0, "%.2f");
        if (milliseconds > 0.0 && ImGui::IsItemHovered())
            ImGui::SetTooltip("%.2f ms, median of %zu frames", milliseconds, cells[i].wall.size());
    }
    const double deferred = medianOf(cells[kColumns - 1]);
    textOrDash(deferred > 0.0 ? medianOf(cells[0]) / deferred : 0.0, "%.2f");
}

}  // namespace

void drawFps(const PanelView& view, PanelAnswer& answer) {
    const FpsRows& fps = view.fps;
    const RenderSettings& settings = fps.settings();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x - 8.0f, 0.5f * window.y}, placeWhen(view), {1.0f, 0.0f});
    bool isOpen = true;
    if (ImGui::Begin("FPS table", &isOpen, ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::Text("FPS at %ux%u, shadows %s", settings.width, settings.height, settings.castShadows ? "on" : "off");
        if (fps.isRunning()) ImGui::ProgressBar(static_cast<float>(fps.progress()));
        if (ImGui::BeginTable("fps", 5, ImGuiTableFlags_Borders | ImGuiTableFlags_SizingFixedFit)) {
            for (const char* title : {"VPLs", "forward", "pre-pass", "deferred", "gain"})
                ImGui::TableSetupColumn(title);
            ImGui::TableHeadersRow();
            for (size_t row = 0; row < fps.cells().size(); row += kColumns) drawRow(&fps.cells()[row]);
            ImGui::EndTable();
        }
    }
    ImGui::End();
    if (!isOpen) answer.commands.emplace_back("fps-table off");
}

}  // namespace manylight
