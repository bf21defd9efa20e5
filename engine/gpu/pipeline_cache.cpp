#include "engine/gpu/pipeline_cache.h"

#include "engine/core/cache_folder.h"
#include "engine/core/file.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace manylight::gpu {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> cacheFile(const Device& device) {
    const std::optional<fs::path> folder = cacheFolder();
    if (!folder) return std::nullopt;
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device.physicalDevice(), &properties);
    std::string name = "pipelines-";
    for (const uint8_t byte : properties.pipelineCacheUUID) name += fmt::format("{:02x}", byte);
    return *folder / (name + fmt::format("-{:x}.bin", properties.driverVersion));
}

}  // namespace

VkPipelineCache loadPipelineCache(Device& device) {
    std::string bytes;
    try {
        if (const auto file = cacheFile(device); file && fs::exists(*file)) bytes = readTextFile(*file);
    } catch (const Error&) {
        bytes.clear();  // an unreadable cache is an empty one
    }
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    info.initialDataSize = bytes.size();
    info.pInitialData = bytes.data();
    VkPipelineCache cache = VK_NULL_HANDLE;
    if (vkCreatePipelineCache(device.handle(), &info, nullptr, &cache) == VK_SUCCESS) return cache;
    info.initialDataSize = 0;
    check(vkCreatePipelineCache(device.handle(), &info, nullptr, &cache), "creating the pipeline cache");
    return cache;
}

void storePipelineCache(Device& device, VkPipelineCache cache) {
    size_t size = 0;
    if (vkGetPipelineCacheData(device.handle(), cache, &size, nullptr) != VK_SUCCESS || size == 0) return;
    std::string bytes(size, '\0');
    if (vkGetPipelineCacheData(device.handle(), cache, &size, bytes.data()) != VK_SUCCESS) return;
    bytes.resize(size);
    try {
        const auto file = cacheFile(device);
        if (!file) return;
        std::error_code ignored;
        fs::create_directories(file->parent_path(), ignored);
        writeTextFile(*file, bytes);
    } catch (const Error&) {
        return;  // a read-only home costs time at the next start, nothing else
    }
}

}  // namespace manylight::gpu
