// The Vulkan instance: validation, and the physical devices one can choose from.
#pragma once

#include "engine/gpu/vulkan.h"

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace manylight::gpu {

/// Set by MANYLIGHT_VALIDATION=off|core|sync; `sync` adds synchronisation validation to `core`.
enum class Validation : uint8_t { Off, Core, Sync };
Validation validationFromEnvironment();

struct DeviceInfo {
    VkPhysicalDevice handle = VK_NULL_HANDLE;
    std::string name;    // "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string driver;  // "llvmpipe, Mesa 22.3.6 (LLVM 15.0.6)"
    VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_OTHER;
    uint32_t apiVersion = 0;

    bool isSoftware() const { return type == VK_PHYSICAL_DEVICE_TYPE_CPU; }
};

class Instance {
  public:
    /// Throws Error if there is no Vulkan 1.3 loader, if validation is asked for and its layer is not installed, or if
    /// an extension of `windowExtensions` is missing.
    explicit Instance(Validation validation, const std::vector<std::string>& windowExtensions = {});
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    VkInstance handle() const { return handle_; }
    Validation validation() const { return validation_; }
    std::vector<DeviceInfo> devices() const;

    /// `selector` is empty (a discrete GPU before an integrated one before a software one), an index into devices(),
    /// or part of a name, case-insensitive. Throws Error listing the devices if nothing matches.
    DeviceInfo choose(const std::string& selector) const;

    /// Validation messages so far (errors and warnings); each was printed on standard error.
    uint64_t validationMessages() const { return messages_; }

  private:
    static VkBool32 onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                              const VkDebugUtilsMessengerCallbackDataEXT*, void*);

    VkInstance handle_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    Validation validation_;
    std::atomic<uint64_t> messages_ = 0;
};

/// "0: NVIDIA H100 (discrete GPU, Vulkan 1.3.280, driver ...)", one line a device.
std::string describeDevices(const std::vector<DeviceInfo>& devices);

}  // namespace manylight::gpu
