// Which pass was running when a device was lost: each pass leaves a mark in host memory as it starts.
#pragma once

#include "engine/gpu/buffer.h"

#include <memory>

namespace manylight {

class Breadcrumbs {
  public:
    explicit Breadcrumbs(gpu::Device& device) : device_(device) {}
    /// Before a command buffer of `passCount` passes is recorded, and no other runs.
    void reset(uint32_t passCount);
    /// Records the mark of pass `pass`, outside of rendering. Marks are not waited for: the last one is a hint, as the
    /// device may have started on a pass while the one before it was still running.
    void drop(VkCommandBuffer commands, uint32_t pass) const;
    /// How many passes have left their mark: 0 before the first one started.
    uint32_t startedCount() const;

  private:
    gpu::Device& device_;
    gpu::Buffer marks_;
    uint32_t passCount_ = 0;
};

}  // namespace manylight
