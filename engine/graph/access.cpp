#include "engine/graph/access.h"

#include "engine/core/check.h"

#include <array>

namespace manylight {

namespace {

constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags2 kGraphics =
    VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr VkPipelineStageFlags2 kVertices = VK_PIPELINE_STAGE_2_VERTEX_INPUT_BIT;
constexpr VkPipelineStageFlags2 kIndirect = VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT;
constexpr VkPipelineStageFlags2 kColor = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkPipelineStageFlags2 kDepth =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
constexpr VkPipelineStageFlags2 kHost = VK_PIPELINE_STAGE_2_HOST_BIT;
constexpr VkPipelineStageFlags2 kEverything = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;

constexpr VkAccessFlags2 kUniformRead = VK_ACCESS_2_UNIFORM_READ_BIT;
constexpr VkAccessFlags2 kStorageRead = VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
constexpr VkAccessFlags2 kStorageWrite = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
constexpr VkAccessFlags2 kStorageBoth = kStorageRead | kStorageWrite;
constexpr VkAccessFlags2 kStructureRead = VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR;
constexpr VkAccessFlags2 kVertexRead = VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT | VK_ACCESS_2_INDEX_READ_BIT;
constexpr VkAccessFlags2 kIndirectRead = VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT;
// A loaded attachment is read even where the shader only writes it, so ColorWrite has both bits too.
constexpr VkAccessFlags2 kColorBoth = VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 kDepthRead = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
constexpr VkAccessFlags2 kDepthBoth = kDepthRead | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 kCopyRead = VK_ACCESS_2_TRANSFER_READ_BIT;
constexpr VkAccessFlags2 kCopyWrite = VK_ACCESS_2_TRANSFER_WRITE_BIT;
constexpr VkAccessFlags2 kEveryWrite = kStorageWrite | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
                                       VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | kCopyWrite;

struct ImageColumns {
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    VkImageUsageFlags usage = 0;
    VkDescriptorType descriptor = kNoDescriptor;
};
constexpr ImageColumns kNoImage{};
constexpr ImageColumns kStorageImage{VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_USAGE_STORAGE_BIT,
                                     VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};
constexpr ImageColumns kColorTarget{VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT};
constexpr ImageColumns kDepthTarget{VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
                                    VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT};
constexpr ImageColumns kDepthTest{VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL,
                                  VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT};
constexpr ImageColumns kCopySource{VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_USAGE_TRANSFER_SRC_BIT};
constexpr ImageColumns kCopyTarget{VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_USAGE_TRANSFER_DST_BIT};
constexpr ImageColumns kPresented{VK_IMAGE_LAYOUT_PRESENT_SRC_KHR};

struct BufferColumns {
    VkBufferUsageFlags usage = 0;
    VkDescriptorType descriptor = kNoDescriptor;
};
constexpr BufferColumns kNoBuffer{};
constexpr BufferColumns kUniform{VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER};
constexpr BufferColumns kStorage{VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
constexpr BufferColumns kTexel{VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT, VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER};
constexpr BufferColumns kStructure{VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR,
                                   VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR};
constexpr BufferColumns kMesh{VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT};
constexpr BufferColumns kMeshAndTexels{kMesh.usage | kTexel.usage, kTexel.descriptor};
constexpr BufferColumns kArguments{VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT};
constexpr BufferColumns kCopyFrom{VK_BUFFER_USAGE_TRANSFER_SRC_BIT};
constexpr BufferColumns kCopyTo{VK_BUFFER_USAGE_TRANSFER_DST_BIT};

enum class Direction { Read, Write, Both };
using enum Direction;

constexpr AccessInfo row(const char* name, VkPipelineStageFlags2 stages, VkAccessFlags2 access, Direction direction,
                         const ImageColumns& image, const BufferColumns& buffer) {
    return {name,         stages,      access,       direction != Write, direction != Read,
            image.layout, image.usage, buffer.usage, image.descriptor,   buffer.descriptor};
}

// clang-format off
constexpr std::array<AccessInfo, kAccessCount> kTable = {  // in the order of the enum
    row("ComputeUniform",          kCompute,    kUniformRead,     Read,  kNoImage,      kUniform),
    row("ComputeStorageRead",      kCompute,    kStorageRead,     Read,  kStorageImage, kStorage),
    row("ComputeStorageWrite",     kCompute,    kStorageWrite,    Write, kStorageImage, kStorage),
    row("ComputeStorageReadWrite", kCompute,    kStorageBoth,     Both,  kStorageImage, kStorage),
    row("ComputeTexelRead",        kCompute,    kStorageRead,     Read,  kNoImage,      kTexel),
    row("ComputeRayQuery",         kCompute,    kStructureRead,   Read,  kNoImage,      kStructure),
    row("GraphicsUniform",         kGraphics,   kUniformRead,     Read,  kNoImage,      kUniform),
    row("GraphicsStorageRead",     kGraphics,   kStorageRead,     Read,  kStorageImage, kStorage),
    row("GraphicsStorageReadWrite", kGraphics,  kStorageBoth,     Both,  kStorageImage, kStorage),
    row("GraphicsTexelRead",       kGraphics,   kStorageRead,     Read,  kNoImage,      kTexel),
    row("GraphicsRayQuery",        kGraphics,   kStructureRead,   Read,  kNoImage,      kStructure),
    row("VertexBuffer",            kVertices,   kVertexRead,      Read,  kNoImage,      kMesh),
    row("VertexAndTexels", kVertices | kGraphics, kVertexRead | kStorageRead, Read, kNoImage, kMeshAndTexels),
    row("IndirectArguments",       kIndirect,   kIndirectRead,    Read,  kNoImage,      kArguments),
    row("ColorWrite",              kColor,      kColorBoth,       Write, kColorTarget,  kNoBuffer),
    row("ColorBlend",              kColor,      kColorBoth,       Both,  kColorTarget,  kNoBuffer),
    row("DepthWrite",              kDepth,      kDepthBoth,       Both,  kDepthTarget,  kNoBuffer),
    row("DepthRead",               kDepth,      kDepthRead,       Read,  kDepthTest,    kNoBuffer),
    row("TransferRead",            kTransfer,   kCopyRead,        Read,  kCopySource,   kCopyFrom),
    row("TransferWrite",           kTransfer,   kCopyWrite,       Write, kCopyTarget,   kCopyTo),
    row("HostRead",                kHost,       VK_ACCESS_2_HOST_READ_BIT, Read, kNoImage, kNoBuffer),
    // Everything, so that whatever stages the presentation's semaphore waits for, the transition is among them.
    row("Present",                 kEverything, VK_ACCESS_2_NONE, Read,  kPresented,    kNoBuffer),
};
// clang-format on

}  // namespace

const AccessInfo& accessInfo(Access access) {
    const auto index = static_cast<uint32_t>(access);
    MANYLIGHT_CHECK(index < kAccessCount);
    return kTable[index];
}

bool fitsImages(const AccessInfo& info) { return info.imageLayout != VK_IMAGE_LAYOUT_UNDEFINED; }

bool fitsBuffers(const AccessInfo& info) { return info.bufferUsage != 0 || !fitsImages(info); }

bool isAttachment(const AccessInfo& info) {
    return (info.imageUsage & (VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT)) != 0;
}

SyncScope readScope(const AccessInfo& info) { return {info.stages, info.access}; }

SyncScope writeScope(const AccessInfo& info) { return {info.stages, info.access & kEveryWrite}; }

SyncScope everythingBefore() { return {kEverything, VK_ACCESS_2_MEMORY_WRITE_BIT}; }

}  // namespace manylight
