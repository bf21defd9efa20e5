#include "engine/gpu/memory_barrier.h"

namespace manylight::gpu {

void recordMemoryBarrier(VkCommandBuffer commands, VkPipelineStageFlags2 stages, VkAccessFlags2 access,
                         VkPipelineStageFlags2 nextStages, VkAccessFlags2 nextAccess) {
    VkMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2;
    barrier.srcStageMask = stages;
    barrier.srcAccessMask = access;
    barrier.dstStageMask = nextStages;
    barrier.dstAccessMask = nextAccess;
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.memoryBarrierCount = 1;
    dependency.pMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace manylight::gpu
