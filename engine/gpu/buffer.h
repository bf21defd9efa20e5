// A buffer with its memory and, where it has a texel format, a view of it as a texel buffer, or where it is one, the
// acceleration structure in it.
#pragma once

#include "engine/gpu/device.h"

#include <optional>
#include <string>

namespace manylight::gpu {

struct BufferInfo {
    VkDeviceSize size = 0;  // bytes; 0 is rounded up to 16, Vulkan has no empty buffers
    VkBufferUsageFlags usage = 0;
    MemoryKind memory = MemoryKind::Device;
    VkFormat texelFormat = VK_FORMAT_UNDEFINED;  // of the texel view, if the usage asks for one
    std::optional<VkAccelerationStructureTypeKHR> structure = std::nullopt;  // that fills the buffer
};

/// Move-only owner. Content is undefined until written: memory is not zeroed.
class Buffer {
  public:
    Buffer() = default;
    Buffer(Device& device, const std::string& name, const BufferInfo& info);
    ~Buffer();
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept {
        swap(other);
        return *this;
    }

    VkBuffer handle() const { return handle_; }
    VkBufferView texelView() const { return texelView_; }
    const VkAccelerationStructureKHR& structure() const { return structure_; }
    VkDeviceSize size() const { return info_.size; }
    const BufferInfo& info() const { return info_; }
    void* mapped() const { return allocation_.mapped; }
    bool exists() const { return handle_ != VK_NULL_HANDLE; }

  private:
    void swap(Buffer& other) noexcept;

    Device* device_ = nullptr;
    BufferInfo info_;
    VkBuffer handle_ = VK_NULL_HANDLE;
    VkBufferView texelView_ = VK_NULL_HANDLE;
    VkAccelerationStructureKHR structure_ = VK_NULL_HANDLE;
    Allocation allocation_;
};

/// Of a buffer with SHADER_DEVICE_ADDRESS usage, on a device that can trace rays.
VkDeviceAddress addressOf(const Device& device, const Buffer& buffer);

}  // namespace manylight::gpu
