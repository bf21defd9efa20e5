#include "apps/view/input.h"

#include "apps/view_model/key_bindings.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace manylight {
namespace {

constexpr float kFontPixels = 13.0f;  // Dear ImGui's own font is drawn for this size
constexpr float kDividerGrip = 6.0f;  // pixels on both sides

int glfwKey(const std::string& key) {
    if (key.size() == 1 && key[0] >= 'a' && key[0] <= 'z') return GLFW_KEY_A + (key[0] - 'a');
    if (key.size() == 2 && key[0] == 'f' && key[1] >= '1' && key[1] <= '9') return GLFW_KEY_F1 + (key[1] - '1');
    if (key == "tab") return GLFW_KEY_TAB;
    if (key == "escape") return GLFW_KEY_ESCAPE;
    if (key == "shift") return GLFW_KEY_LEFT_SHIFT;
    return GLFW_KEY_UNKNOWN;
}

}  // namespace

Input::Input(Window& window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    scalePanels(window.contentScale());
    ImGui_ImplGlfw_InitForOther(window.handle(), true);
}

bool Input::scalePanels(float wanted) {
    const float scale = std::max(std::round(2.0f * wanted) / 2.0f, 0.5f);
    if (scale == panelScale_) return false;
    panelScale_ = scale;
    const float pixelsPerUnit = window_.pixelsPerUnit();
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    ImFontConfig font;
    font.SizePixels = std::floor(kFontPixels * scale);
    io.Fonts->AddFontDefault(&font);
    io.FontGlobalScale = 1.0f / pixelsPerUnit;
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    ImGui::StyleColorsDark();
    style.ScaleAllSizes(scale / pixelsPerUnit);
    style.AntiAliasedLinesUseTex = false;  // our shader takes the nearest texel
    style.Colors[ImGuiCol_WindowBg].w = 0.85f;
    return true;
}

Input::~Input() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Input::beginFrame(double seconds) {
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    if (seconds > 0.0) io.DeltaTime = static_cast<float>(seconds);
    if (click_) {
        io.MousePos = {click_->position.x, click_->position.y};
        io.MouseDown[ImGuiMouseButton_Left] = click_->frame == 1;
    }
    ImGui::NewFrame();
}

bool Input::isDown(const std::string& key) const {
    if (heldKeys_.contains(key)) return true;
    const int code = glfwKey(key);
    return code != GLFW_KEY_UNKNOWN && !ImGui::GetIO().WantCaptureKeyboard &&
           glfwGetKey(window_.handle(), code) == GLFW_PRESS;
}

std::vector<std::string> Input::takePressedKeys() {
    std::vector<std::string> pressed(freshKeys_.begin(), freshKeys_.end());
    freshKeys_.clear();
    std::set<std::string> down;
    for (const KeyBinding& binding : keyBindings()) {
        const int code = glfwKey(binding.key);
        if (code != GLFW_KEY_UNKNOWN && glfwGetKey(window_.handle(), code) == GLFW_PRESS) down.insert(binding.key);
    }
    if (!ImGui::GetIO().WantTextInput)
        std::set_difference(down.begin(), down.end(), downKeys_.begin(), downKeys_.end(), std::back_inserter(pressed));
    downKeys_ = std::move(down);
    return pressed;
}

CameraInput Input::camera() const {
    const auto axis = [&](const char* plus, const char* minus) {
        return (isDown(plus) ? 1.0 : 0.0) - (isDown(minus) ? 1.0 : 0.0);
    };
    CameraInput input;
    input.move = {axis("d", "a"), axis("e", "q"), axis("w", "s")};
    input.fast = isDown("shift");
    input.wheel = wheel_;
    if (dragFrames_ > 0) {
        input.turn = dragLeft_;
        input.pan = dragRight_;
    }
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse || dragsDivider_) return input;
    const glm::dvec2 delta(io.MouseDelta.x, io.MouseDelta.y);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) input.turn += delta;
    if (ImGui::IsMouseDown(ImGuiMouseButton_Right)) input.pan += delta;
    input.wheel += double{io.MouseWheel};
    return input;
}

std::optional<float> Input::draggedDivider(float divider) {
    const ImGuiIO& io = ImGui::GetIO();
    const float width = std::max(io.DisplaySize.x, 1.0f);
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) dragsDivider_ = false;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !io.WantCaptureMouse &&
        std::abs(io.MousePos.x - divider * width) <= kDividerGrip)
        dragsDivider_ = true;
    if (!dragsDivider_) return std::nullopt;
    return std::clamp(io.MousePos.x / width, 0.0f, 1.0f);
}

void Input::pretendKey(const std::string& key, uint32_t frames) {
    if (glfwKey(key) == GLFW_KEY_UNKNOWN) fail("key {}: there is no such key", key);
    freshKeys_.insert(key);
    heldKeys_[key] = frames;
}

void Input::pretendDrag(bool right, glm::dvec2 by, uint32_t frames) {
    dragLeft_ = right ? glm::dvec2(0.0) : by;
    dragRight_ = right ? by : glm::dvec2(0.0);
    dragFrames_ = frames;
}

void Input::endFrame() {
    for (auto& [key, frames] : heldKeys_) --frames;
    std::erase_if(heldKeys_, [](const auto& held) { return held.second == 0; });
    dragFrames_ = dragFrames_ > 0 ? dragFrames_ - 1 : 0;
    wheel_ = 0.0;
    if (click_ && ++click_->frame == 3) click_.reset();
}

}  // namespace manylight
