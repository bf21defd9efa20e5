// Upload and readback through one staging buffer, and single submissions that wait.
#pragma once

#include "engine/gpu/buffer.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace manylight::gpu {

/// Records by `record`, submits and waits for completion. `what` is for error messages.
void submitAndWait(Device& device, const std::string& what, const std::function<void(VkCommandBuffer)>& record);

/// Collects uploads in a staging buffer of a fixed size and copies them in as few submissions as fit.
class Uploader {
  public:
    explicit Uploader(Device& device);
    /// Copies `bytes` to the start of `target`, which needs TRANSFER_DST usage. Complete after flush().
    void upload(const Buffer& target, std::span<const std::byte> bytes);
    /// Submits what is pending and waits.
    void flush();

  private:
    struct Copy {
        VkBuffer target;
        VkBufferCopy region;
    };
    Device& device_;
    Buffer staging_;
    VkDeviceSize used_ = 0;
    std::vector<Copy> pending_;
};

/// Whole content of a buffer that has TRANSFER_SRC usage.
std::vector<std::byte> readBuffer(Device& device, const Buffer& source);

}  // namespace manylight::gpu
