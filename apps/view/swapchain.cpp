#include "apps/view/swapchain.h"

#include <algorithm>
#include <array>

namespace manylight {
namespace {

constexpr std::array kEncodingFormats = {VK_FORMAT_B8G8R8A8_SRGB, VK_FORMAT_R8G8B8A8_SRGB,
                                         VK_FORMAT_A8B8G8R8_SRGB_PACK32};
// What is drawn is encoded already, so formats that leave it alone come first.
constexpr std::array kPlainFormats = {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM,
                                      VK_FORMAT_A8B8G8R8_UNORM_PACK32, VK_FORMAT_A2B10G10R10_UNORM_PACK32,
                                      VK_FORMAT_A2R10G10B10_UNORM_PACK32};

VkPresentModeKHR vulkanMode(PresentMode mode) {
    switch (mode) {
        case PresentMode::Mailbox:
            return VK_PRESENT_MODE_MAILBOX_KHR;
        case PresentMode::Immediate:
            return VK_PRESENT_MODE_IMMEDIATE_KHR;
        case PresentMode::Fifo:
            break;
    }
    return VK_PRESENT_MODE_FIFO_KHR;
}

VkCompositeAlphaFlagBitsKHR compositeAlpha(const VkSurfaceCapabilitiesKHR& capabilities) {
    for (const auto alpha : {VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR, VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR,
                             VK_COMPOSITE_ALPHA_PRE_MULTIPLIED_BIT_KHR})
        if ((capabilities.supportedCompositeAlpha & alpha) != 0) return alpha;
    return VK_COMPOSITE_ALPHA_POST_MULTIPLIED_BIT_KHR;
}

}  // namespace

Swapchain::Swapchain(gpu::Device& device, const Window& window, PresentMode wanted)
    : device_(device), window_(window), surface_(window.createSurface(device)) {
    chooseFormat();
    choosePresentMode(wanted);
    recreate();
}

Swapchain::~Swapchain() {
    vkDeviceWaitIdle(device_.handle());
    dropImages();
    vkDestroySwapchainKHR(device_.handle(), handle_, nullptr);
    vkDestroySurfaceKHR(device_.instance().handle(), surface_, nullptr);
}

void Swapchain::dropImages() {
    images_.clear();
    for (const VkSemaphore semaphore : drawn_) vkDestroySemaphore(device_.handle(), semaphore, nullptr);
    drawn_.clear();
}

void Swapchain::chooseFormat() {
    uint32_t count = 0;
    vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physicalDevice(), surface_, &count, nullptr);
    std::vector<VkSurfaceFormatKHR> formats(count);
    vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physicalDevice(), surface_, &count, formats.data());
    const auto take = [&](const auto& wanted) {
        for (const VkFormat candidate : wanted)
            for (const VkSurfaceFormatKHR& format : formats)
                if (format.format == candidate && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) {
                    format_ = format;
                    return true;
                }
        return false;
    };
    if (!take(kPlainFormats) && !take(kEncodingFormats))
        fail("device {} offers no 8-bit sRGB format for this window; manylight-capture renders without one",
             device_.info().name);
}

void Swapchain::choosePresentMode(PresentMode wanted) {
    uint32_t count = 0;
    vkGetPhysicalDeviceSurfacePresentModesKHR(device_.physicalDevice(), surface_, &count, nullptr);
    std::vector<VkPresentModeKHR> modes(count);
    vkGetPhysicalDeviceSurfacePresentModesKHR(device_.physicalDevice(), surface_, &count, modes.data());
    const bool exists = std::find(modes.begin(), modes.end(), vulkanMode(wanted)) != modes.end();
    mode_ = exists ? vulkanMode(wanted) : VK_PRESENT_MODE_FIFO_KHR;  // which every device has
}

bool Swapchain::encodesItself() const {
    return std::find(kEncodingFormats.begin(), kEncodingFormats.end(), format_.format) != kEncodingFormats.end();
}

std::string Swapchain::describe() const {
    const char* mode = mode_ == VK_PRESENT_MODE_MAILBOX_KHR     ? "mailbox"
                       : mode_ == VK_PRESENT_MODE_IMMEDIATE_KHR ? "immediate"
                                                                : "fifo";
    return fmt::format("{} images of {}x{}, {}{}", images_.size(), size_.x, size_.y, mode,
                       encodesItself() ? ", sRGB format" : "");
}

bool Swapchain::recreate() {
    VkSurfaceCapabilitiesKHR capabilities{};
    gpu::check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physicalDevice(), surface_, &capabilities),
               "asking for the window's size");
    VkExtent2D extent = capabilities.currentExtent;
    if (extent.width == UINT32_MAX) {  // the window takes the images' size
        const glm::uvec2 wanted = window_.framebufferSize();
        extent.width = std::clamp(wanted.x, capabilities.minImageExtent.width, capabilities.maxImageExtent.width);
        extent.height = std::clamp(wanted.y, capabilities.minImageExtent.height, capabilities.maxImageExtent.height);
    }
    if (extent.width == 0 || extent.height == 0) return false;

    VkSwapchainCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
    info.surface = surface_;
    info.minImageCount = std::max(3u, capabilities.minImageCount);
    if (capabilities.maxImageCount > 0) info.minImageCount = std::min(info.minImageCount, capabilities.maxImageCount);
    info.imageFormat = format_.format;
    info.imageColorSpace = format_.colorSpace;
    info.imageExtent = extent;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    info.preTransform = capabilities.currentTransform;
    info.compositeAlpha = compositeAlpha(capabilities);
    info.presentMode = mode_;
    info.clipped = VK_TRUE;
    info.oldSwapchain = handle_;
    VkSwapchainKHR made = VK_NULL_HANDLE;
    gpu::check(vkCreateSwapchainKHR(device_.handle(), &info, nullptr, &made), "making the window's images");
    dropImages();
    vkDestroySwapchainKHR(device_.handle(), handle_, nullptr);
    handle_ = made;
    size_ = {extent.width, extent.height};

    uint32_t count = 0;
    vkGetSwapchainImagesKHR(device_.handle(), handle_, &count, nullptr);
    std::vector<VkImage> handles(count);
    vkGetSwapchainImagesKHR(device_.handle(), handle_, &count, handles.data());
    const gpu::TextureInfo texture{format_.format, extent.width, extent.height, info.imageUsage};
    for (const VkImage image : handles) {
        images_.push_back({gpu::Texture(device_, "window", texture, image), {}});
        VkSemaphoreCreateInfo semaphore{};
        semaphore.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
        drawn_.push_back(VK_NULL_HANDLE);
        gpu::check(vkCreateSemaphore(device_.handle(), &semaphore, nullptr, &drawn_.back()), "making a semaphore");
    }
    return true;
}

std::optional<uint32_t> Swapchain::acquire(VkSemaphore available) {
    uint32_t index = 0;
    const VkResult result =
        vkAcquireNextImageKHR(device_.handle(), handle_, UINT64_MAX, available, VK_NULL_HANDLE, &index);
    if (result == VK_ERROR_OUT_OF_DATE_KHR) return std::nullopt;
    gpu::check(result, "waiting for the window");
    images_[index].state = unknownState();  // whoever showed it is done once `available` is signalled
    return index;
}

bool Swapchain::present(uint32_t index) {
    VkPresentInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &drawn_[index];
    info.swapchainCount = 1;
    info.pSwapchains = &handle_;
    info.pImageIndices = &index;
    const VkResult result = vkQueuePresentKHR(device_.queue(), &info);
    if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) return false;
    gpu::check(result, "presenting");
    return true;
}

}  // namespace manylight
