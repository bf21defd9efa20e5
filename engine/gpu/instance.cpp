#include "engine/gpu/instance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <cstring>

namespace manylight::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

bool layerExists(const char* name) {
    uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(),
                       [&](const auto& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

bool extensionExists(const char* name) {
    uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const auto& extension) { return std::strcmp(extension.extensionName, name) == 0; });
}

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

int preference(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return 0;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return 1;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return 2;
        case VK_PHYSICAL_DEVICE_TYPE_OTHER:
            return 3;
        default:
            return 4;
    }
}

const char* typeName(VkPhysicalDeviceType type) {
    constexpr std::array<const char*, 5> kNames = {"other", "integrated GPU", "discrete GPU", "virtual GPU",
                                                   "software"};
    return kNames[std::min<size_t>(static_cast<size_t>(type), kNames.size() - 1)];
}

}  // namespace

Validation validationFromEnvironment() {
    const char* value = std::getenv("MANYLIGHT_VALIDATION");
    if (value == nullptr || *value == '\0' || std::strcmp(value, "off") == 0) return Validation::Off;
    if (std::strcmp(value, "core") == 0) return Validation::Core;
    if (std::strcmp(value, "sync") == 0) return Validation::Sync;
    failUsage("MANYLIGHT_VALIDATION={}: expected off, core or sync", value);
}

Instance::Instance(Validation validation, const std::vector<std::string>& windowExtensions) : validation_(validation) {
    if (volkInitialize() != VK_SUCCESS)
        fail("no Vulkan loader found (libvulkan.so.1): install your GPU's driver, or mesa-vulkan-drivers");
    if (volkGetInstanceVersion() < VK_API_VERSION_1_3) fail("the Vulkan loader is older than 1.3: update libvulkan1");

    const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                        .pNext = nullptr,
                                        .pApplicationName = "manylight",
                                        .applicationVersion = 0,
                                        .pEngineName = "manylight",
                                        .engineVersion = 0,
                                        .apiVersion = VK_API_VERSION_1_3};
    std::vector<const char*> layers;
    std::vector<const char*> extensions;
    const bool debugUtils = extensionExists(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    if (debugUtils) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    for (const std::string& extension : windowExtensions) {
        if (!extensionExists(extension.c_str())) fail("Vulkan cannot show windows here: {} is missing", extension);
        extensions.push_back(extension.c_str());
    }

    const VkValidationFeatureEnableEXT sync = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    const VkValidationFeaturesEXT features{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                           .pNext = nullptr,
                                           .enabledValidationFeatureCount = validation == Validation::Sync ? 1u : 0u,
                                           .pEnabledValidationFeatures = &sync,
                                           .disabledValidationFeatureCount = 0,
                                           .pDisabledValidationFeatures = nullptr};
    if (validation != Validation::Off) {
        if (!layerExists(kValidationLayer) || !debugUtils)
            fail("MANYLIGHT_VALIDATION is set but {} is not installed (package vulkan-validationlayers)",
                 kValidationLayer);
        layers.push_back(kValidationLayer);
    }
    const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                    .pNext = validation != Validation::Off ? &features : nullptr,
                                    .flags = 0,
                                    .pApplicationInfo = &application,
                                    .enabledLayerCount = static_cast<uint32_t>(layers.size()),
                                    .ppEnabledLayerNames = layers.data(),
                                    .enabledExtensionCount = static_cast<uint32_t>(extensions.size()),
                                    .ppEnabledExtensionNames = extensions.data()};
    check(vkCreateInstance(&info, nullptr, &handle_), "creating the Vulkan instance");
    volkLoadInstance(handle_);

    if (validation != Validation::Off) {
        VkDebugUtilsMessengerCreateInfoEXT messenger{};
        messenger.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
        messenger.messageSeverity =
            VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
        messenger.messageType =
            VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
        messenger.pfnUserCallback = &Instance::onMessage;
        messenger.pUserData = this;
        check(vkCreateDebugUtilsMessengerEXT(handle_, &messenger, nullptr, &messenger_),
              "creating the debug messenger");
    }
}

Instance::~Instance() {
    if (messenger_ != VK_NULL_HANDLE) vkDestroyDebugUtilsMessengerEXT(handle_, messenger_, nullptr);
    if (handle_ != VK_NULL_HANDLE) vkDestroyInstance(handle_, nullptr);
}

VkBool32 Instance::onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT,
                             const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    auto* instance = static_cast<Instance*>(user);
    ++instance->messages_;
    fmt::print(stderr, "Vulkan {}: {}\n",
               severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT ? "error" : "warning", data->pMessage);
    return VK_FALSE;
}

std::vector<DeviceInfo> Instance::devices() const {
    uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(handle_, &count, nullptr), "listing devices");
    std::vector<VkPhysicalDevice> handles(count);
    check(vkEnumeratePhysicalDevices(handle_, &count, handles.data()), "listing devices");

    std::vector<DeviceInfo> infos;
    for (VkPhysicalDevice physicalDevice : handles) {
        VkPhysicalDeviceDriverProperties driver{};
        driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
        VkPhysicalDeviceProperties2 properties{};
        properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
        properties.pNext = &driver;
        vkGetPhysicalDeviceProperties2(physicalDevice, &properties);
        infos.push_back({.handle = physicalDevice,
                         .name = properties.properties.deviceName,
                         .driver = fmt::format("{}, {}", driver.driverName, driver.driverInfo),
                         .type = properties.properties.deviceType,
                         .apiVersion = properties.properties.apiVersion});
    }
    return infos;
}

DeviceInfo Instance::choose(const std::string& selector) const {
    const std::vector<DeviceInfo> all = devices();
    if (all.empty()) fail("no Vulkan device found: install your GPU's driver, or mesa-vulkan-drivers (software)");
    if (selector.empty())
        return *std::min_element(all.begin(), all.end(),
                                 [](const auto& a, const auto& b) { return preference(a.type) < preference(b.type); });

    size_t index = 0;
    const auto [end, error] = std::from_chars(selector.data(), selector.data() + selector.size(), index);
    if (error == std::errc{} && end == selector.data() + selector.size() && index < all.size()) return all[index];
    for (const DeviceInfo& info : all)
        if (lowerCase(info.name).find(lowerCase(selector)) != std::string::npos) return info;
    failUsage("--device {}: no such device; there are\n{}", selector, describeDevices(all));
}

std::string describeDevices(const std::vector<DeviceInfo>& devices) {
    std::string text;
    for (size_t i = 0; i < devices.size(); ++i)
        text += fmt::format("{}: {} ({}, Vulkan {}.{}.{}, driver {})\n", i, devices[i].name, typeName(devices[i].type),
                            VK_API_VERSION_MAJOR(devices[i].apiVersion), VK_API_VERSION_MINOR(devices[i].apiVersion),
                            VK_API_VERSION_PATCH(devices[i].apiVersion), devices[i].driver);
    return text;
}

}  // namespace manylight::gpu
