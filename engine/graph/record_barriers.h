// Turns dependencies into at most one vkCmdPipelineBarrier2.
#pragma once

#include "engine/gpu/buffer.h"
#include "engine/gpu/texture.h"
#include "engine/graph/resource_state.h"

#include <optional>
#include <vector>

namespace manylight {

class BarrierRecorder {
  public:
    void add(const gpu::Texture& texture, const std::optional<Dependency>& dependency);
    void add(const gpu::Buffer& buffer, const std::optional<Dependency>& dependency);
    /// Records what was added; nothing if there was nothing.
    void record(VkCommandBuffer commands) const;

  private:
    std::vector<VkImageMemoryBarrier2> images_;
    std::vector<VkBufferMemoryBarrier2> buffers_;
};

}  // namespace manylight
