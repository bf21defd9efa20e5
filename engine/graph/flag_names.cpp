#include "engine/graph/flag_names.h"

#include <fmt/format.h>

#include <span>
#include <string_view>

namespace manylight {

namespace {

struct Name {
    uint64_t value;
    const char* text;
};

std::string joinNames(uint64_t flags, std::span<const Name> names) {
    std::string text;
    const auto append = [&](std::string_view part) { text.append(text.empty() ? "" : "|").append(part); };
    for (const Name& name : names) {
        if ((flags & name.value) == 0) continue;
        append(name.text);
        flags &= ~name.value;
    }
    if (flags != 0) append(fmt::format("{:#x}", flags));
    return text.empty() ? "none" : text;
}

std::string findName(uint64_t value, std::span<const Name> names) {
    for (const Name& name : names) {
        if (name.value == value) return name.text;
    }
    return std::to_string(value);
}

}  // namespace

std::string stageNames(VkPipelineStageFlags2 stages) {
    static constexpr Name kNames[] = {
        {VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, "indirect"},
        {VK_PIPELINE_STAGE_2_VERTEX_INPUT_BIT, "vertexInput"},
        {VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT, "vertex"},
        {VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, "fragment"},
        {VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT, "earlyTests"},
        {VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT, "lateTests"},
        {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, "colorOutput"},
        {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, "compute"},
        {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, "transfer"},
        {VK_PIPELINE_STAGE_2_HOST_BIT, "host"},
        {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, "allCommands"},
    };
    return joinNames(stages, kNames);
}

std::string accessNames(VkAccessFlags2 access) {
    static constexpr Name kNames[] = {
        {VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, "indirectRead"},
        {VK_ACCESS_2_INDEX_READ_BIT, "indexRead"},
        {VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT, "vertexRead"},
        {VK_ACCESS_2_UNIFORM_READ_BIT, "uniformRead"},
        {VK_ACCESS_2_SHADER_STORAGE_READ_BIT, "storageRead"},
        {VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, "storageWrite"},
        {VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT, "colorRead"},
        {VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, "colorWrite"},
        {VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT, "depthRead"},
        {VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, "depthWrite"},
        {VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR, "structureRead"},
        {VK_ACCESS_2_TRANSFER_READ_BIT, "transferRead"},
        {VK_ACCESS_2_TRANSFER_WRITE_BIT, "transferWrite"},
        {VK_ACCESS_2_HOST_READ_BIT, "hostRead"},
        {VK_ACCESS_2_MEMORY_WRITE_BIT, "anyWrite"},
    };
    return joinNames(access, kNames);
}

std::string imageUsageNames(VkImageUsageFlags usage) {
    static constexpr Name kNames[] = {
        {VK_IMAGE_USAGE_STORAGE_BIT, "storage"},
        {VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, "color"},
        {VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, "depth"},
        {VK_IMAGE_USAGE_TRANSFER_SRC_BIT, "transferSource"},
        {VK_IMAGE_USAGE_TRANSFER_DST_BIT, "transferTarget"},
    };
    return joinNames(usage, kNames);
}

std::string bufferUsageNames(VkBufferUsageFlags usage) {
    static constexpr Name kNames[] = {
        {VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, "uniform"},      {VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, "storage"},
        {VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT, "texel"},  {VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, "vertices"},
        {VK_BUFFER_USAGE_INDEX_BUFFER_BIT, "indices"},        {VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT, "indirect"},
        {VK_BUFFER_USAGE_TRANSFER_SRC_BIT, "transferSource"}, {VK_BUFFER_USAGE_TRANSFER_DST_BIT, "transferTarget"},
        {VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR, "structure"},
    };
    return joinNames(usage, kNames);
}

std::string layoutName(VkImageLayout layout) {
    static constexpr Name kNames[] = {
        {VK_IMAGE_LAYOUT_UNDEFINED, "undefined"},
        {VK_IMAGE_LAYOUT_GENERAL, "general"},
        {VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, "color"},
        {VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL, "depth"},
        {VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL, "depthReadOnly"},
        {VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, "transferSource"},
        {VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, "transferTarget"},
        {VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, "present"},
    };
    return findName(static_cast<uint64_t>(layout), kNames);
}

std::string formatName(VkFormat format) {
    static constexpr Name kNames[] = {
        {VK_FORMAT_UNDEFINED, "undefined"},
        {VK_FORMAT_R8G8B8A8_UNORM, "rgba8"},
        {VK_FORMAT_R8G8B8A8_SRGB, "rgba8Srgb"},
        {VK_FORMAT_B8G8R8A8_UNORM, "bgra8"},
        {VK_FORMAT_B8G8R8A8_SRGB, "bgra8Srgb"},
        {VK_FORMAT_R16G16B16A16_SFLOAT, "rgba16f"},
        {VK_FORMAT_R32_SFLOAT, "r32f"},
        {VK_FORMAT_R32_UINT, "r32ui"},
        {VK_FORMAT_R32G32_SFLOAT, "rg32f"},
        {VK_FORMAT_R32G32_UINT, "rg32ui"},
        {VK_FORMAT_R32G32B32A32_SFLOAT, "rgba32f"},
        {VK_FORMAT_R32G32B32A32_UINT, "rgba32ui"},
        {VK_FORMAT_D32_SFLOAT, "d32f"},
    };
    return findName(static_cast<uint64_t>(format), kNames);
}

}  // namespace manylight
