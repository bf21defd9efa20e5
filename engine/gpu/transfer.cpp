#include "engine/gpu/transfer.h"

#include "engine/gpu/memory_barrier.h"

#include <algorithm>
#include <cstring>

namespace manylight::gpu {
namespace {

constexpr VkDeviceSize kStagingBytes = VkDeviceSize{16} << 20;

/// A command pool, buffer and fence that die together, also when a call in between throws.
struct OneShot {
    VkDevice device;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkFence fence = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;

    OneShot(Device& owner, const std::string& what) : device(owner.handle()) {
        VkCommandPoolCreateInfo poolInfo{};
        poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        poolInfo.queueFamilyIndex = owner.queueFamily();
        check(vkCreateCommandPool(device, &poolInfo, nullptr, &pool), what);
        VkFenceCreateInfo fenceInfo{};
        fenceInfo.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
        check(vkCreateFence(device, &fenceInfo, nullptr, &fence), what);
        VkCommandBufferAllocateInfo allocate{};
        allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        allocate.commandPool = pool;
        allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
        allocate.commandBufferCount = 1;
        check(vkAllocateCommandBuffers(device, &allocate, &commands), what);
    }
    ~OneShot() {
        vkDestroyFence(device, fence, nullptr);
        vkDestroyCommandPool(device, pool, nullptr);
    }
    OneShot(const OneShot&) = delete;
    OneShot& operator=(const OneShot&) = delete;
};

}  // namespace

void submitAndWait(Device& device, const std::string& what, const std::function<void(VkCommandBuffer)>& record) {
    const OneShot shot(device, what);
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(vkBeginCommandBuffer(shot.commands, &begin), what);
    record(shot.commands);
    check(vkEndCommandBuffer(shot.commands), what);

    VkCommandBufferSubmitInfo commands{};
    commands.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
    commands.commandBuffer = shot.commands;
    VkSubmitInfo2 submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &commands;
    check(vkQueueSubmit2(device.queue(), 1, &submit, shot.fence), what);
    check(vkWaitForFences(device.handle(), 1, &shot.fence, VK_TRUE, UINT64_MAX), what);
}

Uploader::Uploader(Device& device)
    : device_(device),
      staging_(device, "staging", {kStagingBytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, MemoryKind::Upload}) {}

void Uploader::upload(const Buffer& target, std::span<const std::byte> bytes) {
    VkDeviceSize done = 0;
    while (done < bytes.size()) {
        if (used_ == kStagingBytes) flush();
        const VkDeviceSize piece = std::min<VkDeviceSize>(bytes.size() - done, kStagingBytes - used_);
        std::memcpy(static_cast<std::byte*>(staging_.mapped()) + used_, bytes.data() + done, piece);
        pending_.push_back({target.handle(), {used_, done, piece}});
        used_ += piece;
        done += piece;
    }
    used_ = std::min((used_ + 15) / 16 * 16, kStagingBytes);
}

void Uploader::flush() {
    if (!pending_.empty())
        submitAndWait(device_, "uploading", [&](VkCommandBuffer commands) {
            for (const Copy& copy : pending_)
                vkCmdCopyBuffer(commands, staging_.handle(), copy.target, 1, &copy.region);
        });
    pending_.clear();
    used_ = 0;
}

std::vector<std::byte> readBuffer(Device& device, const Buffer& source) {
    const Buffer target(device, "readback", {source.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT, MemoryKind::Readback});
    submitAndWait(device, "reading a buffer back", [&](VkCommandBuffer commands) {
        const VkBufferCopy region{0, 0, source.size()};
        vkCmdCopyBuffer(commands, source.handle(), target.handle(), 1, &region);
        recordMemoryBarrier(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                            VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
    });
    std::vector<std::byte> bytes(source.size());
    std::memcpy(bytes.data(), target.mapped(), bytes.size());
    return bytes;
}

}  // namespace manylight::gpu
