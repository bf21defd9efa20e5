#include "engine/gpu/buffer.h"

#include "engine/gpu/texture.h"

#include <algorithm>
#include <utility>

namespace manylight::gpu {

Buffer::Buffer(Device& device, const std::string& name, const BufferInfo& info) : device_(&device), info_(info) {
    info_.size = std::max<VkDeviceSize>(info.size, 16);
    VkBufferCreateInfo create{};
    create.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    create.size = info_.size;
    create.usage = info.usage;
    check(vkCreateBuffer(device.handle(), &create, nullptr, &handle_), "creating buffer " + name);
    VkMemoryRequirements requirements;
    vkGetBufferMemoryRequirements(device.handle(), handle_, &requirements);
    allocation_ = device.allocator().allocate(requirements, info.memory, false);
    check(vkBindBufferMemory(device.handle(), handle_, allocation_.memory, allocation_.offset), "binding " + name);
    device.setName(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<uint64_t>(handle_), name);

    if (info.structure) {
        VkAccelerationStructureCreateInfoKHR structure{};
        structure.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR;
        structure.buffer = handle_;
        structure.size = info.size;
        structure.type = *info.structure;
        check(vkCreateAccelerationStructureKHR(device.handle(), &structure, nullptr, &structure_), "creating " + name);
        device.setName(VK_OBJECT_TYPE_ACCELERATION_STRUCTURE_KHR, reinterpret_cast<uint64_t>(structure_), name);
    }

    constexpr VkBufferUsageFlags kTexel =
        VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
    if (info.texelFormat == VK_FORMAT_UNDEFINED || (info.usage & kTexel) == 0) return;
    const VkDeviceSize texelSize = texelBytes(info.texelFormat);
    if (info_.size / texelSize > device.limits().maxTexelBufferElements)
        fail("buffer {} needs {} texels, device {} allows {}: the scene is too large for it", name,
             info_.size / texelSize, device.info().name, device.limits().maxTexelBufferElements);
    VkBufferViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
    view.buffer = handle_;
    view.format = info.texelFormat;
    view.range = VK_WHOLE_SIZE;
    check(vkCreateBufferView(device.handle(), &view, nullptr, &texelView_), "creating a texel view of " + name);
}

Buffer::~Buffer() {
    if (handle_ == VK_NULL_HANDLE) return;
    if (texelView_ != VK_NULL_HANDLE) vkDestroyBufferView(device_->handle(), texelView_, nullptr);
    if (structure_ != VK_NULL_HANDLE) vkDestroyAccelerationStructureKHR(device_->handle(), structure_, nullptr);
    vkDestroyBuffer(device_->handle(), handle_, nullptr);
    device_->allocator().free(allocation_);
}

void Buffer::swap(Buffer& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(info_, other.info_);
    std::swap(handle_, other.handle_);
    std::swap(texelView_, other.texelView_);
    std::swap(structure_, other.structure_);
    std::swap(allocation_, other.allocation_);
}

VkDeviceAddress addressOf(const Device& device, const Buffer& buffer) {
    VkBufferDeviceAddressInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO;
    info.buffer = buffer.handle();
    return vkGetBufferDeviceAddress(device.handle(), &info);
}

}  // namespace manylight::gpu
