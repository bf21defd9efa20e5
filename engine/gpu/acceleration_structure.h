// Acceleration structures of VK_KHR_acceleration_structure: triangles, and instances of them.
#pragma once

#include "engine/gpu/buffer.h"

#include <glm/glm.hpp>

#include <span>
#include <string>
#include <vector>

namespace manylight::gpu {

/// What a buffer with corners of triangles is used for besides.
inline constexpr VkBufferUsageFlags kUsageOfStructureInput =
    VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;

/// Triangles one behind the other in a buffer, three corners each, 16 bytes a corner: xyz is its position.
struct TriangleRange {
    uint32_t first = 0;
    uint32_t count = 0;
    bool isOpaque = true;  // otherwise shaders are asked about every hit
};

/// One structure per range; none (Buffer::exists() is false) where there are no triangles. Waits.
std::vector<Buffer> buildBottomLevels(Device& device, const Buffer& corners, std::span<const TriangleRange> ranges);

/// scenePoint = sceneFromMesh * meshPoint + center.
struct StructureInstance {
    const Buffer* mesh = nullptr;  // of buildBottomLevels()
    glm::mat3 sceneFromMesh{1.0f};
    glm::vec3 center{0.0f};
};

/// Instances that rays meet from both sides, counted as in the list. Waits. Throws Error if they are too many.
Buffer buildTopLevel(Device& device, std::span<const StructureInstance> instances);

}  // namespace manylight::gpu
