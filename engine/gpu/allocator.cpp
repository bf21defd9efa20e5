#include "engine/gpu/allocator.h"

#include "engine/core/check.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>

namespace manylight::gpu {

constexpr VkDeviceSize kBlockSize = VkDeviceSize{64} << 20;

/// One vkAllocateMemory; `holes` maps the offset of each free range to its size.
struct MemoryBlock {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize size = 0;
    uint32_t memoryType = 0;
    bool images = false;
    void* mapped = nullptr;
    std::map<VkDeviceSize, VkDeviceSize> holes;

    /// First hole that fits, cut in at most three. Empty if there is none.
    std::optional<VkDeviceSize> take(VkDeviceSize bytes, VkDeviceSize alignment) {
        for (auto hole = holes.begin(); hole != holes.end(); ++hole) {
            const auto [start, length] = *hole;
            const VkDeviceSize aligned = (start + alignment - 1) / alignment * alignment;
            if (aligned + bytes > start + length) continue;
            holes.erase(hole);
            if (aligned > start) holes[start] = aligned - start;
            if (aligned + bytes < start + length) holes[aligned + bytes] = start + length - aligned - bytes;
            return aligned;
        }
        return std::nullopt;
    }

    void give(VkDeviceSize offset, VkDeviceSize bytes) {
        auto hole = holes.emplace(offset, bytes).first;
        if (const auto next = std::next(hole); next != holes.end() && offset + bytes == next->first) {
            hole->second += next->second;
            holes.erase(next);
        }
        if (hole != holes.begin()) {
            const auto previous = std::prev(hole);
            if (previous->first + previous->second == offset) {
                previous->second += hole->second;
                holes.erase(hole);
            }
        }
    }
};

Allocator::Allocator(VkPhysicalDevice physicalDevice, VkDevice device, bool hasAddresses)
    : device_(device), hasAddresses_(hasAddresses) {
    vkGetPhysicalDeviceMemoryProperties(physicalDevice, &properties_);
}

Allocator::~Allocator() {
    for (const auto& block : blocks_) vkFreeMemory(device_, block->memory, nullptr);
}

uint32_t Allocator::memoryType(uint32_t allowedTypes, MemoryKind kind) const {
    constexpr VkMemoryPropertyFlags kHost = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    const VkMemoryPropertyFlags required = kind == MemoryKind::Device ? 0 : kHost;
    const VkMemoryPropertyFlags preferred = kind == MemoryKind::Device     ? VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT
                                            : kind == MemoryKind::Readback ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT
                                                                           : 0;
    for (const VkMemoryPropertyFlags wanted : {required | preferred, required})
        for (uint32_t type = 0; type < properties_.memoryTypeCount; ++type)
            if ((allowedTypes >> type & 1u) != 0 && (properties_.memoryTypes[type].propertyFlags & wanted) == wanted)
                return type;
    fail("the device has no memory type for {} resources",
         kind == MemoryKind::Device ? "device-local" : "host-visible");
}

Allocation Allocator::allocate(const VkMemoryRequirements& requirements, MemoryKind kind, bool isImage) {
    const uint32_t type = memoryType(requirements.memoryTypeBits, kind);
    const auto cut = [&](MemoryBlock& block) -> std::optional<Allocation> {
        const auto offset = block.take(requirements.size, requirements.alignment);
        if (!offset) return std::nullopt;
        bytesInUse_ += requirements.size;
        void* mapped = block.mapped != nullptr ? static_cast<std::byte*>(block.mapped) + *offset : nullptr;
        return Allocation{&block, block.memory, *offset, requirements.size, mapped};
    };
    for (const auto& block : blocks_)
        if (block->memoryType == type && block->images == isImage)
            if (auto allocation = cut(*block)) return *allocation;

    auto block = std::make_unique<MemoryBlock>();
    block->size = std::max(kBlockSize, requirements.size);
    block->memoryType = type;
    block->images = isImage;
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = block->size;
    info.memoryTypeIndex = type;
    VkMemoryAllocateFlagsInfo flags{};
    flags.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO;
    flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
    if (hasAddresses_ && !isImage) info.pNext = &flags;
    check(vkAllocateMemory(device_, &info, nullptr, &block->memory),
          fmt::format("allocating {} MiB", block->size >> 20));
    block->holes[0] = block->size;
    blocks_.push_back(std::move(block));
    // Whatever it is made for: where all memory is of one type, uploads share blocks with the device's own resources.
    if ((properties_.memoryTypes[type].propertyFlags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) != 0)
        check(vkMapMemory(device_, blocks_.back()->memory, 0, VK_WHOLE_SIZE, 0, &blocks_.back()->mapped),
              "mapping memory");
    const auto allocation = cut(*blocks_.back());
    MANYLIGHT_CHECK(allocation.has_value(), "a fresh block of {} bytes", blocks_.back()->size);
    return *allocation;
}

void Allocator::free(const Allocation& allocation) {
    if (allocation.block == nullptr) return;
    bytesInUse_ -= allocation.size;
    MemoryBlock& block = *allocation.block;
    block.give(allocation.offset, allocation.size);
    if (block.holes.begin()->second != block.size) return;
    vkFreeMemory(device_, block.memory, nullptr);
    std::erase_if(blocks_, [&](const auto& candidate) { return candidate.get() == &block; });
}

VkDeviceSize Allocator::bytesReserved() const {
    VkDeviceSize sum = 0;
    for (const auto& block : blocks_) sum += block->size;
    return sum;
}

}  // namespace manylight::gpu
