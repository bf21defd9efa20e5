// A buffer with its memory and, where it has a texel format, a view of it as a texel buffer.
#pragma once

#include "engine/gpu/device.h"

#include <string>

namespace manylight::gpu {

struct BufferInfo {
    VkDeviceSize size = 0;  // bytes; 0 is rounded up to 16, Vulkan has no empty buffers
    VkBufferUsageFlags usage = 0;
    MemoryKind memory = MemoryKind::Device;
    VkFormat texelFormat = VK_FORMAT_UNDEFINED;  // of the texel view, if the usage asks for one
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
    Allocation allocation_;
};

}  // namespace manylight::gpu
