#include "engine/gpu/texture.h"

#include "engine/core/check.h"

#include <utility>

namespace manylight::gpu {

uint32_t texelBytes(VkFormat format) {
    switch (format) {
        case VK_FORMAT_R32G32B32A32_SFLOAT:
        case VK_FORMAT_R32G32B32A32_UINT:
            return 16;
        case VK_FORMAT_R8G8B8A8_UNORM:
        case VK_FORMAT_R32_UINT:
        case VK_FORMAT_D32_SFLOAT:
            return 4;
        default:
            MANYLIGHT_CHECK(format == VK_FORMAT_UNDEFINED, "texelBytes of an unknown format");
            return 0;
    }
}

bool isDepthFormat(VkFormat format) { return format == VK_FORMAT_D32_SFLOAT; }

Texture::Texture(Device& device, const std::string& name, const TextureInfo& info) : device_(&device), info_(info) {
    const uint32_t limit = device.limits().maxImageDimension2D;
    if (info.width == 0 || info.height == 0 || info.width > limit || info.height > limit)
        fail("image size {}x{}: device {} allows 1x1 to {}x{}", info.width, info.height, device.info().name, limit,
             limit);
    VkImageCreateInfo create{};
    create.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    create.imageType = VK_IMAGE_TYPE_2D;
    create.format = info.format;
    create.extent = {info.width, info.height, 1};
    create.mipLevels = 1;
    create.arrayLayers = 1;
    create.samples = VK_SAMPLE_COUNT_1_BIT;
    create.tiling = VK_IMAGE_TILING_OPTIMAL;
    create.usage = info.usage;
    check(vkCreateImage(device.handle(), &create, nullptr, &handle_), "creating image " + name);
    VkMemoryRequirements requirements;
    vkGetImageMemoryRequirements(device.handle(), handle_, &requirements);
    allocation_ = device.allocator().allocate(requirements, MemoryKind::Device, true);
    check(vkBindImageMemory(device.handle(), handle_, allocation_.memory, allocation_.offset), "binding " + name);
    device.setName(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(handle_), name);

    makeView(name);
}

Texture::Texture(Device& device, const std::string& name, const TextureInfo& info, VkImage borrowed)
    : device_(&device), info_(info), handle_(borrowed), isBorrowed_(true) {
    device.setName(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(handle_), name);
    makeView(name);
}

void Texture::makeView(const std::string& name) {
    constexpr VkImageUsageFlags kTransferOnly = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    if ((info_.usage & ~kTransferOnly) == 0) return;
    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = handle_;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = info_.format;
    view.subresourceRange = {aspect(), 0, 1, 0, 1};
    check(vkCreateImageView(device_->handle(), &view, nullptr, &view_), "creating a view of " + name);
}

Texture::~Texture() {
    if (handle_ == VK_NULL_HANDLE) return;
    if (view_ != VK_NULL_HANDLE) vkDestroyImageView(device_->handle(), view_, nullptr);
    if (isBorrowed_) return;
    vkDestroyImage(device_->handle(), handle_, nullptr);
    device_->allocator().free(allocation_);
}

VkImageAspectFlags Texture::aspect() const {
    return isDepthFormat(info_.format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

void Texture::swap(Texture& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(info_, other.info_);
    std::swap(handle_, other.handle_);
    std::swap(view_, other.view_);
    std::swap(allocation_, other.allocation_);
    std::swap(isBorrowed_, other.isBorrowed_);
}

}  // namespace manylight::gpu
