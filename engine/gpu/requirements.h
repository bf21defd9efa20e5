// What Manylight asks of a device, in one place: the check and the creation read the same list.
#pragma once

#include "engine/gpu/instance.h"

#include <vector>

namespace manylight::gpu {

std::vector<const char*> requiredExtensions();

/// The feature structs with every required feature set, chained for vkCreateDevice.
struct RequiredFeatures {
    VkPhysicalDeviceFeatures2 core{};
    VkPhysicalDeviceVulkan12Features vulkan12{};
    VkPhysicalDeviceVulkan13Features vulkan13{};

    RequiredFeatures();
    RequiredFeatures(const RequiredFeatures&) = delete;
    RequiredFeatures& operator=(const RequiredFeatures&) = delete;
    const void* chain() const { return &core; }
};

/// Throws one Error that lists everything the device lacks.
void requireEverything(const DeviceInfo& device);

}  // namespace manylight::gpu
