// The panels: they show the state and answer with commands.
#pragma once

#include "apps/view/viewer.h"

namespace manylight {

/// What the panels look at.
struct PanelView {
    const ViewState& state;
    const Side& main;
    const Side& other;
    const Comparison& comparison;
    const FpsRows& fps;
    gpu::Device& device;
    std::string window;  // the swapchain, in words
    bool hasReference = false;
    bool isRescaled = false;           // windows go where they went at first
    std::optional<size_t>& heldLight;  // by the mouse; kept from frame to frame
};

struct PanelAnswer {
    std::vector<std::string> commands;
    bool isDragging = false;  // a value or a light is being dragged: pictures should come quickly
};

/// Between Input::beginFrame() and ImGui::Render().
PanelAnswer drawPanels(const PanelView& view);

/// One setting as a widget that fits its description; changes become "set PREFIXoption value".
void drawSetting(const SettingHelp& help, const Json& value, const std::string& prefix, PanelAnswer& answer);

void drawLights(const PanelView& view, PanelAnswer& answer);
void drawLightHandles(const PanelView& view, PanelAnswer& answer);
void drawTimings(const PanelView& view, PanelAnswer& answer);
void drawFps(const PanelView& view, PanelAnswer& answer);
void drawPlan(const PanelView& view);
void drawKeys(const PanelView& view);

/// When a window takes the place and the size that it is given.
int placeWhen(const PanelView& view);
/// Pixels, or units of the window, per unit that the panels were designed for.
float panelScale();

}  // namespace manylight
