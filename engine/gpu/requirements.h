// What Manylight asks of a device, in one place: the check and the creation read the same list.
#pragma once

#include "engine/gpu/instance.h"

#include <string>
#include <vector>

namespace manylight::gpu {

std::vector<const char*> requiredExtensions();
/// Those of rays that the device traces itself: enabled where missingForRayQueries() finds nothing missing.
std::vector<const char*> rayQueryExtensions();

/// The feature structs with every required feature set, chained for vkCreateDevice.
struct RequiredFeatures {
    VkPhysicalDeviceFeatures2 core{};
    VkPhysicalDeviceVulkan12Features vulkan12{};
    VkPhysicalDeviceVulkan13Features vulkan13{};
    VkPhysicalDeviceAccelerationStructureFeaturesKHR accelerationStructures{};  // these two only with addRayQueries()
    VkPhysicalDeviceRayQueryFeaturesKHR rayQueries{};

    RequiredFeatures();
    RequiredFeatures(const RequiredFeatures&) = delete;
    RequiredFeatures& operator=(const RequiredFeatures&) = delete;
    void addRayQueries();
    const void* chain() const { return &core; }
};

/// Throws one Error that lists everything the device lacks.
void requireEverything(const DeviceInfo& device);

/// Extensions and features that the device lacks for tracing rays itself, "a, b"; empty if it can. Never required.
std::string missingForRayQueries(const DeviceInfo& device);

}  // namespace manylight::gpu
