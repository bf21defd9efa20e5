// Vulkan through volk, and the one place that turns a VkResult into an error message.
#pragma once

#include "engine/core/error.h"

#include <volk.h>

#include <string_view>

namespace manylight::gpu {

/// Name of a result code, e.g. "VK_ERROR_DEVICE_LOST".
const char* resultName(VkResult result);

/// Throws Error with a sentence a user can act on (out of memory, device lost) for any failure code.
void check(VkResult result, std::string_view what);

}  // namespace manylight::gpu
