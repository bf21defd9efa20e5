#include "engine/graph/record_barriers.h"

namespace manylight {

void BarrierRecorder::add(const gpu::Texture& texture, const std::optional<Dependency>& dependency) {
    if (!dependency) return;
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    barrier.srcStageMask = dependency->before.stages;
    barrier.srcAccessMask = dependency->before.access;
    barrier.dstStageMask = dependency->after.stages;
    barrier.dstAccessMask = dependency->after.access;
    barrier.oldLayout = dependency->oldLayout;
    barrier.newLayout = dependency->newLayout;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = texture.handle();
    barrier.subresourceRange = {texture.aspect(), 0, 1, 0, 1};
    images_.push_back(barrier);
}

void BarrierRecorder::add(const gpu::Buffer& buffer, const std::optional<Dependency>& dependency) {
    if (!dependency) return;
    VkBufferMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2;
    barrier.srcStageMask = dependency->before.stages;
    barrier.srcAccessMask = dependency->before.access;
    barrier.dstStageMask = dependency->after.stages;
    barrier.dstAccessMask = dependency->after.access;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.buffer = buffer.handle();
    barrier.size = VK_WHOLE_SIZE;
    buffers_.push_back(barrier);
}

void BarrierRecorder::record(VkCommandBuffer commands) const {
    if (images_.empty() && buffers_.empty()) return;
    VkDependencyInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    info.bufferMemoryBarrierCount = static_cast<uint32_t>(buffers_.size());
    info.pBufferMemoryBarriers = buffers_.data();
    info.imageMemoryBarrierCount = static_cast<uint32_t>(images_.size());
    info.pImageMemoryBarriers = images_.data();
    vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace manylight
