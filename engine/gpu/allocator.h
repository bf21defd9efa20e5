// Device memory in few allocations: blocks of tens of MiB, cut up first-fit.
#pragma once

#include "engine/gpu/vulkan.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace manylight::gpu {

struct MemoryBlock;

/// A piece of a block. `mapped` is non-null for host-visible memory.
struct Allocation {
    MemoryBlock* block = nullptr;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize offset = 0;
    VkDeviceSize size = 0;
    void* mapped = nullptr;
};

enum class MemoryKind : uint8_t {
    Device,    // device-local
    Upload,    // host-visible and coherent
    Readback,  // host-visible, coherent, cached where there is such a type
};

class Allocator {
  public:
    /// `hasAddresses`: shaders and builds may refer to buffers by their addresses.
    Allocator(VkPhysicalDevice physicalDevice, VkDevice device, bool hasAddresses);
    ~Allocator();
    Allocator(const Allocator&) = delete;
    Allocator& operator=(const Allocator&) = delete;

    /// Throws Error when the device is out of memory. Optimal-tiling images and buffers never share a block, so
    /// bufferImageGranularity needs no thought.
    Allocation allocate(const VkMemoryRequirements& requirements, MemoryKind kind, bool isImage);
    void free(const Allocation& allocation);

    uint32_t blockCount() const { return static_cast<uint32_t>(blocks_.size()); }
    VkDeviceSize bytesInUse() const { return bytesInUse_; }
    VkDeviceSize bytesReserved() const;

  private:
    uint32_t memoryType(uint32_t allowedTypes, MemoryKind kind) const;

    VkDevice device_;
    bool hasAddresses_;
    VkPhysicalDeviceMemoryProperties properties_{};
    std::vector<std::unique_ptr<MemoryBlock>> blocks_;
    VkDeviceSize bytesInUse_ = 0;
};

}  // namespace manylight::gpu
