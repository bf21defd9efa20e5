// Keys and mouse: of the window, and as scripts pretend them.
#pragma once

#include "apps/view/window.h"
#include "apps/view_model/camera_motion.h"

#include <map>
#include <optional>
#include <set>
#include <string>

namespace manylight {

/// Dear ImGui's context, fed by the window.
class Input {
  public:
    explicit Input(Window& window);
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    /// Text and panels of so many pixels per unit that they were designed for. True if that is new: PanelAtlas must be
    /// made again. Between two frames.
    bool scalePanels(float scale);
    float panelScale() const { return panelScale_; }

    /// Begins a frame of the panels. `seconds`: since the last one; 0: as the clock says.
    void beginFrame(double seconds);
    /// Names of the keys pressed since the last call, unless the panels want them.
    std::vector<std::string> takePressedKeys();
    /// What is asked of the camera now, less what the panels take.
    CameraInput camera() const;
    /// Mouse, as a share of the window's width, while it drags the divider near `divider`.
    std::optional<float> draggedDivider(float divider);

    void pretendKey(const std::string& key, uint32_t frames);
    void pretendDrag(bool right, glm::dvec2 by, uint32_t frames);
    void pretendWheel(double notches) { wheel_ += notches; }
    /// Presses and releases the left button there, for the panels; takes three frames.
    void pretendClick(glm::vec2 position) { click_ = Click{position, 0}; }
    bool isClicking() const { return click_.has_value(); }
    /// Counts down what is pretended; to be called at the end of each frame.
    void endFrame();

  private:
    struct Click {
        glm::vec2 position{0.0f};
        uint32_t frame = 0;
    };
    bool isDown(const std::string& key) const;

    Window& window_;
    float panelScale_ = 0.0f;
    std::optional<Click> click_;
    std::map<std::string, uint32_t> heldKeys_;  // frames left
    std::set<std::string> freshKeys_;           // pretended since the last look
    std::set<std::string> downKeys_;            // of the keyboard, at the last look
    glm::dvec2 dragLeft_{0.0};
    glm::dvec2 dragRight_{0.0};
    uint32_t dragFrames_ = 0;
    double wheel_ = 0.0;
    bool dragsDivider_ = false;
};

}  // namespace manylight
