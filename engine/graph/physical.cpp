#include "engine/graph/physical.h"

#include "engine/core/check.h"
#include "engine/gpu/transfer.h"
#include "engine/graph/record_barriers.h"

#include <cstring>

namespace manylight {

ImageHandle importPhysical(FrameGraph& graph, const std::string& name, PhysicalImage& image) {
    const gpu::TextureInfo& info = image.texture.info();
    return graph.importImage(name, {info.format, info.width, info.height}, image.state, &image);
}

BufferHandle importPhysical(FrameGraph& graph, const std::string& name, PhysicalBuffer& buffer) {
    const gpu::BufferInfo& info = buffer.buffer.info();
    return graph.importBuffer(name, {info.size, info.texelFormat}, buffer.state, &buffer);
}

std::vector<std::byte> readPhysical(gpu::Device& device, PhysicalImage& image) {
    const gpu::TextureInfo& info = image.texture.info();
    const VkDeviceSize size = VkDeviceSize{info.width} * info.height * gpu::texelBytes(info.format);
    PhysicalBuffer target{
        gpu::Buffer(device, "readback", {size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryKind::Readback}), {}};
    gpu::submitAndWait(device, "reading an image back", [&](VkCommandBuffer commands) {
        BarrierRecorder before;
        before.add(image.texture, advance(image.state, Access::TransferRead, ResourceKind::Image));
        before.record(commands);
        VkBufferImageCopy region{};
        region.imageSubresource = {image.texture.aspect(), 0, 0, 1};
        region.imageExtent = {info.width, info.height, 1};
        vkCmdCopyImageToBuffer(commands, image.texture.handle(), accessInfo(Access::TransferRead).imageLayout,
                               target.buffer.handle(), 1, &region);
        advance(target.state, Access::TransferWrite, ResourceKind::Buffer);
        BarrierRecorder after;
        after.add(target.buffer, advance(target.state, Access::HostRead, ResourceKind::Buffer));
        after.record(commands);
    });
    std::vector<std::byte> bytes(size);
    std::memcpy(bytes.data(), target.buffer.mapped(), size);
    return bytes;
}

void writePhysical(gpu::Device& device, PhysicalImage& image, std::span<const std::byte> bytes) {
    const gpu::TextureInfo& info = image.texture.info();
    MANYLIGHT_CHECK(bytes.size() == size_t{info.width} * info.height * gpu::texelBytes(info.format), "writePhysical()");
    const gpu::Buffer source(device, "upload",
                             {bytes.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, gpu::MemoryKind::Upload});
    std::memcpy(source.mapped(), bytes.data(), bytes.size());
    gpu::submitAndWait(device, "uploading an image", [&](VkCommandBuffer commands) {
        BarrierRecorder before;
        before.add(image.texture, advance(image.state, Access::TransferWrite, ResourceKind::Image));
        before.record(commands);
        VkBufferImageCopy region{};
        region.imageSubresource = {image.texture.aspect(), 0, 0, 1};
        region.imageExtent = {info.width, info.height, 1};
        vkCmdCopyBufferToImage(commands, source.handle(), image.texture.handle(),
                               accessInfo(Access::TransferWrite).imageLayout, 1, &region);
    });
}

}  // namespace manylight
