// The images that the window system shows, as resources of the frame graph.
#pragma once

#include "apps/view/window.h"
#include "engine/graph/physical.h"

#include <optional>

namespace manylight {

enum class PresentMode : uint8_t { Fifo, Mailbox, Immediate };

class Swapchain {
  public:
    Swapchain(gpu::Device& device, const Window& window, PresentMode wanted);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    /// Makes images of the window's size. The device must not use the old ones any more. False where the window has no
    /// pixels at the moment.
    bool recreate();
    glm::uvec2 size() const { return size_; }
    /// The format encodes sRGB by itself.
    bool encodesItself() const;
    std::string describe() const;

    /// The next image to draw to, ready when `available` is signalled; empty if the window has changed: recreate().
    std::optional<uint32_t> acquire(VkSemaphore available);
    PhysicalImage& image(uint32_t index) { return images_[index]; }
    /// To be signalled when the image is drawn.
    VkSemaphore isDrawn(uint32_t index) const { return drawn_[index]; }
    /// False if the window has changed: recreate().
    bool present(uint32_t index);

  private:
    void chooseFormat();
    void choosePresentMode(PresentMode wanted);
    void dropImages();

    gpu::Device& device_;
    const Window& window_;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    VkSwapchainKHR handle_ = VK_NULL_HANDLE;
    VkSurfaceFormatKHR format_{};
    VkPresentModeKHR mode_ = VK_PRESENT_MODE_FIFO_KHR;
    glm::uvec2 size_{0};
    std::vector<PhysicalImage> images_;
    std::vector<VkSemaphore> drawn_;
};

}  // namespace manylight
