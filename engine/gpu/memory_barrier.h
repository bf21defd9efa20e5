// A barrier over all memory, for single submissions: frames have theirs from the graph.
#pragma once

#include "engine/gpu/vulkan.h"

namespace manylight::gpu {

/// What `access` in `stages` did before is there for `nextAccess` in `nextStages`.
void recordMemoryBarrier(VkCommandBuffer commands, VkPipelineStageFlags2 stages, VkAccessFlags2 access,
                         VkPipelineStageFlags2 nextStages, VkAccessFlags2 nextAccess);

}  // namespace manylight::gpu
