#include "engine/gpu/device.h"

#include "engine/gpu/requirements.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace manylight::gpu {
namespace {

uint32_t chooseQueueFamily(VkInstance instance, VkPhysicalDevice physicalDevice,
                           const std::optional<WindowSystem>& window) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice, &count, families.data());
    constexpr VkQueueFlags kWanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    bool foundOne = false;
    for (uint32_t family = 0; family < count; ++family) {
        if ((families[family].queueFlags & kWanted) != kWanted || families[family].timestampValidBits == 0) continue;
        foundOne = true;
        if (!window || window->canPresent(instance, physicalDevice, family)) return family;
    }
    if (foundOne) fail("the device has no queue that renders and presents to a window");
    fail("the device has no queue with graphics, compute and timestamps");
}

bool hasExtension(VkPhysicalDevice device, std::string_view name) {
    uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const VkExtensionProperties& extension) { return name == extension.extensionName; });
}

}  // namespace

Device::Device(const DeviceOptions& options)
    : instance_(std::make_unique<Instance>(
          options.validation, options.window ? options.window->instanceExtensions : std::vector<std::string>{})) {
    info_ = instance_->choose(options.select);
    requireEverything(info_);

    VkPhysicalDeviceVulkan13Properties properties13{};
    properties13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES;
    VkPhysicalDeviceVulkan11Properties properties11{};
    properties11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES;
    properties11.pNext = &properties13;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &properties11;
    vkGetPhysicalDeviceProperties2(info_.handle, &properties);
    limits_ = properties.properties.limits;
    subgroupSize_ = properties11.subgroupSize;
    canRequireSubgroupSize_ = (properties13.requiredSubgroupSizeStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0;

    queueFamily_ = chooseQueueFamily(instance_->handle(), info_.handle, options.window);
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queueInfo{};
    queueInfo.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queueInfo.queueFamilyIndex = queueFamily_;
    queueInfo.queueCount = 1;
    queueInfo.pQueuePriorities = &priority;

    RequiredFeatures required;
    std::vector<const char*> extensions = requiredExtensions();
    if (options.window) {
        if (!hasExtension(info_.handle, VK_KHR_SWAPCHAIN_EXTENSION_NAME))
            fail("device {} cannot present to windows", info_.name);
        extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    }
    missingForRays_ = missingForRayQueries(info_);
    if (canTraceRays()) {
        required.addRayQueries();
        for (const char* name : rayQueryExtensions()) extensions.push_back(name);
    }
    VkDeviceCreateInfo deviceInfo{};
    deviceInfo.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    deviceInfo.pNext = required.chain();
    deviceInfo.queueCreateInfoCount = 1;
    deviceInfo.pQueueCreateInfos = &queueInfo;
    deviceInfo.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    deviceInfo.ppEnabledExtensionNames = extensions.data();
    check(vkCreateDevice(info_.handle, &deviceInfo, nullptr, &handle_), "creating the device");
    volkLoadDevice(handle_);
    vkGetDeviceQueue(handle_, queueFamily_, 0, &queue_);
    allocator_ = std::make_unique<Allocator>(info_.handle, handle_, canTraceRays());
}

Device::~Device() {
    if (handle_ == VK_NULL_HANDLE) return;
    vkDeviceWaitIdle(handle_);
    allocator_.reset();
    vkDestroyDevice(handle_, nullptr);
}

void Device::setName(VkObjectType type, uint64_t object, const std::string& name) const {
    if (vkSetDebugUtilsObjectNameEXT == nullptr) return;
    VkDebugUtilsObjectNameInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
    info.objectType = type;
    info.objectHandle = object;
    info.pObjectName = name.c_str();
    vkSetDebugUtilsObjectNameEXT(handle_, &info);
}

void Device::waitIdle() const { check(vkDeviceWaitIdle(handle_), "waiting for the device"); }

}  // namespace manylight::gpu
