#include "engine/graph/gpu_timers.h"

#include <algorithm>

namespace manylight {

GpuTimers::~GpuTimers() {
    if (pool_ != VK_NULL_HANDLE) vkDestroyQueryPool(device_.handle(), pool_, nullptr);
}

void GpuTimers::reset(uint32_t count) {
    count_ = count;
    if (count > capacity_) {
        if (pool_ != VK_NULL_HANDLE) vkDestroyQueryPool(device_.handle(), pool_, nullptr);
        capacity_ = std::max(count, 2 * capacity_);
        VkQueryPoolCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = 2 * capacity_;
        gpu::check(vkCreateQueryPool(device_.handle(), &info, nullptr, &pool_), "creating timers");
    }
    if (count > 0) vkResetQueryPool(device_.handle(), pool_, 0, 2 * count);
}

void GpuTimers::write(VkCommandBuffer commands, uint32_t query) const {
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_, query);
}

std::vector<GpuTimers::Interval> GpuTimers::read() const {
    if (count_ == 0) return {};
    std::vector<uint64_t> ticks(2 * size_t{count_});
    gpu::check(vkGetQueryPoolResults(device_.handle(), pool_, 0, 2 * count_, ticks.size() * sizeof(uint64_t),
                                     ticks.data(), sizeof(uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
               "reading timers");
    const double millisecondsPerTick = static_cast<double>(device_.limits().timestampPeriod) * 1e-6;
    std::vector<Interval> intervals;
    for (uint32_t i = 0; i < count_; ++i)
        intervals.push_back({static_cast<double>(ticks[2 * i] - ticks[0]) * millisecondsPerTick,
                             static_cast<double>(ticks[2 * i + 1] - ticks[0]) * millisecondsPerTick});
    return intervals;
}

}  // namespace manylight
