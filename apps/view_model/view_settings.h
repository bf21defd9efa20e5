// What the viewer can be told beside the renderer's settings; described in the same way.
#pragma once

#include "apps/view_model/camera_motion.h"
#include "engine/techniques/settings.h"

namespace manylight {

enum class Compare : uint8_t {
    Off,
    Split,       // the other side beyond a divider
    Difference,  // from the other side, in false colours
};

struct ViewSettings {
    bool panel = true;
    bool help = false;
    bool timings = true;
    double panelScale = 0.0;  // of text and panels; 0: as the screen asks for
    Navigation navigation = Navigation::Fly;
    double budget = 80.0;        // milliseconds a frame may take while something moves; 0: no limit
    double pixelScale = 1.0;     // of the picture, per pixel of the window
    uint32_t frameLimit = 4096;  // frames after which a still picture is done
    Compare compare = Compare::Off;
    double divider = 0.5;  // share of the width
    bool plays = false;    // the scene's animation
    double at = 0.0;       // seconds into it
    double speed = 1.0;
    bool loops = true;
};

const std::vector<SettingHelp>& viewSettingHelps();
bool isViewSetting(const std::string& option);
/// Of scenes with an animation only.
bool isPlaybackSetting(const std::string& option);
/// Like applySetting(), settingValue() and applySettings() of the renderer's.
void applyViewSetting(ViewSettings& settings, const std::string& option, const std::string& value);
Json viewSettingValue(const ViewSettings& settings, const std::string& option);

/// The next choice of a switch or a choice, as text; empty for a number.
std::string nextChoice(const SettingHelp& help, const Json& value);

/// A value as applySetting() takes it.
std::string settingText(const Json& value);

}  // namespace manylight
