// Readable names of the Vulkan flags that appear in dumps.
#pragma once

#include <volk.h>

#include <string>

namespace manylight {

/// Names joined by '|'; "none" for 0; bits without a name as one hexadecimal number.
std::string stageNames(VkPipelineStageFlags2 stages);
std::string accessNames(VkAccessFlags2 access);
std::string imageUsageNames(VkImageUsageFlags usage);
std::string bufferUsageNames(VkBufferUsageFlags usage);
std::string layoutName(VkImageLayout layout);
/// The formats the engine uses by name, others by number.
std::string formatName(VkFormat format);

}  // namespace manylight
