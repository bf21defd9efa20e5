// The logical device: one queue, the allocator, names, and what the device can do.
#pragma once

#include "engine/gpu/allocator.h"
#include "engine/gpu/instance.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace manylight::gpu {

/// What a device needs to show its pictures in windows.
struct WindowSystem {
    std::vector<std::string> instanceExtensions;
    /// Whether a queue of this family can present.
    std::function<bool(VkInstance, VkPhysicalDevice, uint32_t family)> canPresent;
};

struct DeviceOptions {
    std::string select;  // see Instance::choose
    Validation validation = validationFromEnvironment();
    std::optional<WindowSystem> window = std::nullopt;
};

class Device {
  public:
    /// Throws one Error that lists every feature, extension and limit the device lacks; with a window, also if no queue
    /// can present.
    explicit Device(const DeviceOptions& options = {});
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    VkDevice handle() const { return handle_; }
    VkPhysicalDevice physicalDevice() const { return info_.handle; }
    VkQueue queue() const { return queue_; }
    uint32_t queueFamily() const { return queueFamily_; }
    Instance& instance() { return *instance_; }
    Allocator& allocator() { return *allocator_; }
    const DeviceInfo& info() const { return info_; }
    const VkPhysicalDeviceLimits& limits() const { return limits_; }

    /// Lanes per subgroup that compute shaders run with (8 on lavapipe, 32 or 64 on GPUs).
    uint32_t subgroupSize() const { return subgroupSize_; }
    /// True if a compute pipeline may ask for exactly subgroupSize().
    bool canRequireSubgroupSize() const { return canRequireSubgroupSize_; }

    /// What the device lacks for tracing rays itself (VK_KHR_ray_query): empty if it can.
    const std::string& missingForRays() const { return missingForRays_; }
    bool canTraceRays() const { return missingForRays_.empty(); }

    /// Names an object for validation messages and debuggers; free when no layer listens.
    void setName(VkObjectType type, uint64_t object, const std::string& name) const;

    void waitIdle() const;

  private:
    std::unique_ptr<Instance> instance_;
    DeviceInfo info_;
    VkPhysicalDeviceLimits limits_{};
    uint32_t subgroupSize_ = 0;
    bool canRequireSubgroupSize_ = false;
    std::string missingForRays_;
    VkDevice handle_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    uint32_t queueFamily_ = 0;
    std::unique_ptr<Allocator> allocator_;
};

}  // namespace manylight::gpu
