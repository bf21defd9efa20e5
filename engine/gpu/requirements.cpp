#include "engine/gpu/requirements.h"

#include <fmt/ranges.h>

#include <cstring>
#include <string>

namespace manylight::gpu {
namespace {

/// One required feature: where it sits and how it is called.
template <typename Struct>
struct Feature {
    VkBool32 Struct::*member;
    const char* name;
};

constexpr Feature<VkPhysicalDeviceFeatures> kCore[] = {
    {&VkPhysicalDeviceFeatures::fragmentStoresAndAtomics, "fragmentStoresAndAtomics"},
};
constexpr Feature<VkPhysicalDeviceVulkan12Features> kVulkan12[] = {
    {&VkPhysicalDeviceVulkan12Features::scalarBlockLayout, "scalarBlockLayout"},
    {&VkPhysicalDeviceVulkan12Features::hostQueryReset, "hostQueryReset"},
};
constexpr Feature<VkPhysicalDeviceVulkan13Features> kVulkan13[] = {
    {&VkPhysicalDeviceVulkan13Features::dynamicRendering, "dynamicRendering"},
    {&VkPhysicalDeviceVulkan13Features::synchronization2, "synchronization2"},
    {&VkPhysicalDeviceVulkan13Features::maintenance4, "maintenance4"},
    {&VkPhysicalDeviceVulkan13Features::subgroupSizeControl, "subgroupSizeControl"},
    {&VkPhysicalDeviceVulkan13Features::computeFullSubgroups, "computeFullSubgroups"},
};

template <typename Struct, size_t N>
void enable(Struct& features, const Feature<Struct> (&list)[N]) {
    for (const auto& feature : list) features.*feature.member = VK_TRUE;
}

template <typename Struct, size_t N>
void collectMissing(const Struct& features, const Feature<Struct> (&list)[N], std::vector<std::string>& missing) {
    for (const auto& feature : list)
        if (features.*feature.member == VK_FALSE) missing.emplace_back(feature.name);
}

constexpr Feature<VkPhysicalDeviceVulkan12Features> kVulkan12OfRays[] = {
    {&VkPhysicalDeviceVulkan12Features::bufferDeviceAddress, "bufferDeviceAddress"},
};
constexpr Feature<VkPhysicalDeviceAccelerationStructureFeaturesKHR> kAccelerationStructures[] = {
    {&VkPhysicalDeviceAccelerationStructureFeaturesKHR::accelerationStructure, "accelerationStructure"},
};
constexpr Feature<VkPhysicalDeviceRayQueryFeaturesKHR> kRayQueries[] = {
    {&VkPhysicalDeviceRayQueryFeaturesKHR::rayQuery, "rayQuery"},
};

void collectMissingExtensions(VkPhysicalDevice device, const std::vector<const char*>& wanted,
                              std::vector<std::string>& missing) {
    uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    for (const char* name : wanted) {
        bool found = false;
        for (const auto& extension : extensions) found = found || std::strcmp(extension.extensionName, name) == 0;
        if (!found) missing.emplace_back(name);
    }
}

void collectMissingFormats(VkPhysicalDevice device, std::vector<std::string>& missing) {
    struct Use {
        VkFormat format;
        VkFormatFeatureFlags2 features;
        bool buffer;
        const char* name;
    };
    constexpr VkFormatFeatureFlags2 kTarget =
        VK_FORMAT_FEATURE_2_STORAGE_IMAGE_BIT | VK_FORMAT_FEATURE_2_COLOR_ATTACHMENT_BIT;
    constexpr Use kUses[] = {
        {VK_FORMAT_R32G32B32A32_SFLOAT, kTarget | VK_FORMAT_FEATURE_2_COLOR_ATTACHMENT_BLEND_BIT, false,
         "blendable R32G32B32A32_SFLOAT storage images"},
        {VK_FORMAT_R32G32B32A32_UINT, kTarget, false, "R32G32B32A32_UINT storage images and attachments"},
        {VK_FORMAT_D32_SFLOAT, VK_FORMAT_FEATURE_2_DEPTH_STENCIL_ATTACHMENT_BIT, false, "D32_SFLOAT attachments"},
        {VK_FORMAT_R32_UINT, kTarget, false, "R32_UINT storage images and attachments"},
        {VK_FORMAT_R32G32B32A32_UINT, VK_FORMAT_FEATURE_2_STORAGE_TEXEL_BUFFER_BIT, true,
         "R32G32B32A32_UINT storage texel buffers"},
        {VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_FEATURE_2_STORAGE_TEXEL_BUFFER_BIT, true,
         "R8G8B8A8_UNORM storage texel buffers"},
    };
    for (const Use& use : kUses) {
        VkFormatProperties3 format{};
        format.sType = VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_3;
        VkFormatProperties2 properties{};
        properties.sType = VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_2;
        properties.pNext = &format;
        vkGetPhysicalDeviceFormatProperties2(device, use.format, &properties);
        const VkFormatFeatureFlags2 have = use.buffer ? format.bufferFeatures : format.optimalTilingFeatures;
        if ((have & use.features) != use.features) missing.emplace_back(use.name);
    }
}

void collectMissingSubgroupOperations(VkPhysicalDevice device, std::vector<std::string>& missing) {
    VkPhysicalDeviceVulkan11Properties subgroup{};
    subgroup.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &subgroup;
    vkGetPhysicalDeviceProperties2(device, &properties);
    constexpr VkSubgroupFeatureFlags kNeeded = VK_SUBGROUP_FEATURE_SHUFFLE_BIT | VK_SUBGROUP_FEATURE_VOTE_BIT;
    if ((subgroup.subgroupSupportedOperations & kNeeded) != kNeeded ||
        (subgroup.subgroupSupportedStages & VK_SHADER_STAGE_COMPUTE_BIT) == 0)
        missing.emplace_back("subgroup shuffle and vote in compute shaders");
}

}  // namespace

std::vector<const char*> requiredExtensions() { return {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME}; }

std::vector<const char*> rayQueryExtensions() {
    return {VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME, VK_KHR_RAY_QUERY_EXTENSION_NAME,
            VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME};
}

RequiredFeatures::RequiredFeatures() {
    core.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    core.pNext = &vulkan12;
    vulkan12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    vulkan12.pNext = &vulkan13;
    vulkan13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    enable(core.features, kCore);
    enable(vulkan12, kVulkan12);
    enable(vulkan13, kVulkan13);
}

void RequiredFeatures::addRayQueries() {
    vulkan13.pNext = &accelerationStructures;
    accelerationStructures.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR;
    accelerationStructures.pNext = &rayQueries;
    rayQueries.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR;
    enable(vulkan12, kVulkan12OfRays);
    enable(accelerationStructures, kAccelerationStructures);
    enable(rayQueries, kRayQueries);
}

void requireEverything(const DeviceInfo& device) {
    std::vector<std::string> missing;
    if (device.apiVersion < VK_API_VERSION_1_3) {
        missing.emplace_back("Vulkan 1.3");
    } else {
        RequiredFeatures have;  // same chain, filled with what the device has
        vkGetPhysicalDeviceFeatures2(device.handle, &have.core);
        collectMissing(have.core.features, kCore, missing);
        collectMissing(have.vulkan12, kVulkan12, missing);
        collectMissing(have.vulkan13, kVulkan13, missing);
        collectMissingExtensions(device.handle, requiredExtensions(), missing);
        collectMissingFormats(device.handle, missing);
        collectMissingSubgroupOperations(device.handle, missing);
    }
    if (!missing.empty()) fail("device {} cannot run Manylight, it lacks: {}", device.name, fmt::join(missing, ", "));
}

std::string missingForRayQueries(const DeviceInfo& device) {
    std::vector<std::string> missing;
    collectMissingExtensions(device.handle, rayQueryExtensions(), missing);
    if (missing.empty()) {
        RequiredFeatures have;  // same chain, filled with what the device has
        have.addRayQueries();
        vkGetPhysicalDeviceFeatures2(device.handle, &have.core);
        collectMissing(have.vulkan12, kVulkan12OfRays, missing);
        collectMissing(have.accelerationStructures, kAccelerationStructures, missing);
        collectMissing(have.rayQueries, kRayQueries, missing);
    }
    return fmt::format("{}", fmt::join(missing, ", "));
}

}  // namespace manylight::gpu
