// How a pass touches a resource. One table says what each access means to Vulkan; no other code spells a stage, an
// access mask or a layout.
#pragma once

#include <volk.h>

#include <cstdint>

namespace manylight {

enum class Access : uint8_t {
    ComputeUniform,
    ComputeStorageRead,
    ComputeStorageWrite,      ///< overwrites the resource: what it held before is lost
    ComputeStorageReadWrite,  ///< changes it, or writes only parts of it
    ComputeTexelRead,         ///< imageBuffer, through the buffer's texel format
    ComputeRayQuery,          ///< acceleration structure: the pass runs the entry points compiled for ray queries
    GraphicsUniform,          ///< Graphics...: vertex and fragment shader
    GraphicsStorageRead,
    GraphicsStorageReadWrite,
    GraphicsTexelRead,
    GraphicsRayQuery,
    VertexBuffer,     ///< vertices or indices
    VertexAndTexels,  ///< vertices, and texels for the vertex and fragment shader
    IndirectArguments,
    ColorWrite,
    ColorBlend,
    DepthWrite,  ///< test and write
    DepthRead,   ///< test only
    TransferRead,
    TransferWrite,
    HostRead,
    Present,
};
inline constexpr uint32_t kAccessCount = static_cast<uint32_t>(Access::Present) + 1;
inline constexpr VkDescriptorType kNoDescriptor = VK_DESCRIPTOR_TYPE_MAX_ENUM;

/// Stages of the pipeline and the memory accesses they make.
struct SyncScope {
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0;

    bool operator==(const SyncScope&) const = default;
};

/// One row of the table.
struct AccessInfo {
    const char* name;
    VkPipelineStageFlags2 stages;
    VkAccessFlags2 access;
    bool reads;
    bool writes;
    VkImageLayout imageLayout;  // undefined: for buffers only
    VkImageUsageFlags imageUsage;
    VkBufferUsageFlags bufferUsage;  // none, with a layout: for images only
    VkDescriptorType imageDescriptor;
    VkDescriptorType bufferDescriptor;
};

const AccessInfo& accessInfo(Access access);

bool fitsImages(const AccessInfo& info);
bool fitsBuffers(const AccessInfo& info);
/// Color or depth attachment: it is loaded unless it is cleared.
bool isAttachment(const AccessInfo& info);
/// What a barrier before the access has to make memory visible to.
SyncScope readScope(const AccessInfo& info);
/// What a barrier after the access has to make available: its writes.
SyncScope writeScope(const AccessInfo& info);
/// All that was submitted earlier, whatever it was.
SyncScope everythingBefore();

}  // namespace manylight
