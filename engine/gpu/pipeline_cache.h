// Vulkan's pipeline cache on disk: $XDG_CACHE_HOME/manylight (or ~/.cache/manylight), one file a device and driver.
#pragma once

#include "engine/gpu/device.h"

namespace manylight::gpu {

VkPipelineCache loadPipelineCache(Device& device);

/// Written atomically; silently skipped where no cache folder can be made.
void storePipelineCache(Device& device, VkPipelineCache cache);

}  // namespace manylight::gpu
