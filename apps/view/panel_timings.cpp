#include "apps/view/panels.h"

#include <imgui.h>

#include <algorithm>

namespace manylight {
namespace {

constexpr double kMostMedians = 4.0;  // that the plot is high

/// Colours that differ from their neighbours: steps of the golden angle around the hues.
ImU32 colourOf(size_t pass) {
    const float hue = static_cast<float>(pass) * 0.381966f;
    ImVec4 rgb(0, 0, 0, 1);
    ImGui::ColorConvertHSVtoRGB(hue - static_cast<float>(static_cast<int>(hue)), 0.6f, 0.9f, rgb.x, rgb.y, rgb.z);
    return ImGui::ColorConvertFloat4ToU32(rgb);
}

/// One bar for each frame, newest to the right: its passes on top of each other, and the whole frame as a dot.
void drawStack(const TimeHistory& times, const ImVec2& size, double most) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, IM_COL32(0, 0, 0, 120));
    const float width = size.x / static_cast<float>(TimeHistory::kFrames);
    const auto height = [&](double milliseconds) {
        return static_cast<float>(std::min(milliseconds / most, 1.0)) * size.y;
    };
    for (size_t i = 0; i < times.frames().size(); ++i) {
        const TimeHistory::Frame& frame = times.frames()[i];
        const float left = corner.x + size.x - width * static_cast<float>(times.frames().size() - i);
        double sum = 0.0;
        for (size_t pass = 0; pass < frame.milliseconds.size(); ++pass) {
            const float bottom = corner.y + size.y - height(sum);
            sum += frame.milliseconds[pass];
            const float top = corner.y + size.y - height(sum);
            if (bottom - top >= 0.25f) list.AddRectFilled({left, top}, {left + width, bottom}, colourOf(pass));
        }
        const float total = corner.y + size.y - height(frame.total);
        list.AddRectFilled({left, total - 1.0f}, {left + width, total + 1.0f}, IM_COL32_WHITE);
    }
    ImGui::Dummy(size);
}

/// Of the plot: a single frame, such as one in which pipelines were compiled, does not make the others vanish.
double topOf(const TimeHistory& times) {
    double most = 1.0;
    for (const TimeHistory::Frame& frame : times.frames()) most = std::max({most, frame.total, frame.sum()});
    return std::min(most, std::max(kMostMedians * times.medianTotal(), 1.0));
}

double mebibytes(uint64_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

/// What the panels themselves cost, and how quickly the picture follows.
void drawCosts(const ViewState& state, PanelAnswer& answer) {
    ImGui::Text("panels %.2f ms to build, %.2f ms to draw", state.shown.panelCpu, state.shown.panelGpu);
    if (state.latency.isRunning()) {
        ImGui::TextUnformatted("latency: measuring");
        return;
    }
    if (ImGui::SmallButton("measure latency")) answer.commands.emplace_back("latency");
    if (state.latency.samples().empty()) return;
    ImGui::SameLine();
    ImGui::Text("%.2f frames, %.1f ms", state.latency.medianFrames(), 1e3 * state.latency.medianSeconds());
}

}  // namespace

void drawTimings(const PanelView& view, PanelAnswer& answer) {
    const TimeHistory& times = view.state.shown.times;
    const float scale = panelScale();
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({window.x - 328 * scale, 8 * scale}, placeWhen(view));
    ImGui::SetNextWindowCollapsed(window.x < 900 * scale, placeWhen(view));
    if (ImGui::Begin("Times", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
        const double most = topOf(times);
        ImGui::Text("up to %.1f ms; white: from frame to frame", most);
        drawStack(times, {240 * scale, 80 * scale}, most);
        for (size_t pass = times.passes().size(); pass-- > 0;) {
            if (times.mean(pass) == 0.0) continue;
            ImGui::ColorButton(times.passes()[pass].c_str(), ImGui::ColorConvertU32ToFloat4(colourOf(pass)),
                               ImGuiColorEditFlags_NoTooltip, {ImGui::GetFontSize(), ImGui::GetFontSize()});
            ImGui::SameLine();
            ImGui::Text("%7.2f ms  %s", times.mean(pass), times.passes()[pass].c_str());
        }
        drawCosts(view.state, answer);
        const gpu::Allocator& memory = view.device.allocator();
        ImGui::Text("memory %.1f MiB of %.0f reserved, scene %.1f", mebibytes(memory.bytesInUse()),
                    mebibytes(memory.bytesReserved()), mebibytes(view.main.renderer().gpuScene().totalBytes));
        ImGui::Text("window %s", view.window.c_str());
        ImGui::Text("%s", view.device.info().name.c_str());
    }
    ImGui::End();
}

void drawPlan(const PanelView& view) {
    for (const PlanDecision& decision : view.main.renderer().plan().decisions) {
        ImGui::Bullet();
        ImGui::TextWrapped("%s %s: %s", decision.what.c_str(), decision.leftOut ? "left out" : "kept",
                           decision.reason.c_str());
    }
}

}  // namespace manylight
