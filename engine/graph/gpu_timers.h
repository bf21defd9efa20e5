// A pair of timestamps for every pass of a frame.
#pragma once

#include "engine/gpu/device.h"

#include <vector>

namespace manylight {

class GpuTimers {
  public:
    explicit GpuTimers(gpu::Device& device) : device_(device) {}
    ~GpuTimers();
    GpuTimers(const GpuTimers&) = delete;
    GpuTimers& operator=(const GpuTimers&) = delete;

    /// Makes room for `count` intervals and forgets the old ones. The device must be done with them.
    void reset(uint32_t count);
    void begin(VkCommandBuffer commands, uint32_t interval) const { write(commands, 2 * interval); }
    void end(VkCommandBuffer commands, uint32_t interval) const { write(commands, 2 * interval + 1); }

    /// Begin and end of every interval in milliseconds since the first begin. All must have been recorded and run.
    struct Interval {
        double begin = 0.0;
        double end = 0.0;
    };
    std::vector<Interval> read() const;

  private:
    void write(VkCommandBuffer commands, uint32_t query) const;

    gpu::Device& device_;
    VkQueryPool pool_ = VK_NULL_HANDLE;
    uint32_t capacity_ = 0;
    uint32_t count_ = 0;
};

}  // namespace manylight
