// A 2D image with its memory and view: an attachment or a storage image.
#pragma once

#include "engine/gpu/device.h"

#include <string>

namespace manylight::gpu {

struct TextureInfo {
    VkFormat format = VK_FORMAT_UNDEFINED;
    uint32_t width = 1;
    uint32_t height = 1;
    VkImageUsageFlags usage = 0;
};

/// Bytes per texel of the formats the engine uses.
uint32_t texelBytes(VkFormat format);
bool isDepthFormat(VkFormat format);

/// Move-only owner; throws Error if the device cannot make an image that large.
class Texture {
  public:
    Texture() = default;
    Texture(Device& device, const std::string& name, const TextureInfo& info);
    /// A view of somebody else's image (a swapchain's), which has to outlive it.
    Texture(Device& device, const std::string& name, const TextureInfo& info, VkImage borrowed);
    ~Texture();
    Texture(Texture&& other) noexcept { swap(other); }
    Texture& operator=(Texture&& other) noexcept {
        swap(other);
        return *this;
    }

    VkImage handle() const { return handle_; }
    VkImageView view() const { return view_; }
    const TextureInfo& info() const { return info_; }
    VkImageAspectFlags aspect() const;
    bool exists() const { return handle_ != VK_NULL_HANDLE; }

  private:
    void makeView(const std::string& name);
    void swap(Texture& other) noexcept;

    Device* device_ = nullptr;
    TextureInfo info_;
    VkImage handle_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
    Allocation allocation_;
    bool isBorrowed_ = false;
};

}  // namespace manylight::gpu
