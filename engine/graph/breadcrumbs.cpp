#include "engine/graph/breadcrumbs.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace manylight {

void Breadcrumbs::reset(uint32_t passCount) {
    passCount_ = passCount;
    const VkDeviceSize bytes = std::max<VkDeviceSize>(passCount * sizeof(uint32_t), 256);
    if (!marks_.exists() || marks_.size() < bytes)
        marks_ =
            gpu::Buffer(device_, "breadcrumbs", {bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryKind::Readback});
    std::memset(marks_.mapped(), 0, static_cast<size_t>(marks_.size()));
}

void Breadcrumbs::drop(VkCommandBuffer commands, uint32_t pass) const {
    vkCmdFillBuffer(commands, marks_.handle(), pass * sizeof(uint32_t), sizeof(uint32_t), 1);
}

uint32_t Breadcrumbs::startedCount() const {
    std::vector<uint32_t> marks(passCount_);
    std::memcpy(marks.data(), marks_.mapped(), marks.size() * sizeof(uint32_t));
    const auto last = std::find(marks.rbegin(), marks.rend(), 1u);
    return static_cast<uint32_t>(marks.rend() - last);
}

}  // namespace manylight
