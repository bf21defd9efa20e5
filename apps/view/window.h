// The window: GLFW, and what it tells of keys and mouse.
#pragma once

#include "engine/gpu/device.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <string>
#include <vector>

struct GLFWwindow;

namespace manylight {

class Window {
  public:
    /// Throws Error, with a hint at manylight-capture, where there is no display or Vulkan cannot draw to it.
    Window(const std::string& title, glm::uvec2 size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// For gpu::DeviceOptions.
    gpu::WindowSystem system() const;
    VkSurfaceKHR createSurface(gpu::Device& device) const;

    /// Asks the system what happened. While the window is minimised it waits, at most `seconds`.
    void poll(double seconds = 0.0);
    bool shouldClose() const;
    void close();
    bool isMinimised() const;
    /// Where nothing manages windows, as on a virtual screen, nothing can be minimised: it then counts as such.
    void minimise();
    void restore();
    /// In pixels; zero while minimised.
    glm::uvec2 framebufferSize() const;
    void resize(glm::uvec2 size);
    void setTitle(const std::string& title);
    /// Pixels of the screen per unit that text was designed for.
    float contentScale() const;
    /// Pixels per unit of positions in the window.
    float pixelsPerUnit() const;
    /// Files dropped onto the window since the last call.
    std::vector<std::filesystem::path> takeDroppedFiles();
    /// As if the user had dropped them.
    void drop(const std::vector<std::string>& files);
    GLFWwindow* handle() const { return window_; }

  private:
    GLFWwindow* window_ = nullptr;
    std::vector<std::filesystem::path> dropped_;
    bool isMadeMinimised_ = false;
};

}  // namespace manylight
