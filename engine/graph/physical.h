// Images and buffers that outlive a frame, each with the state the graph left it in.
#pragma once

#include "engine/gpu/buffer.h"
#include "engine/gpu/texture.h"
#include "engine/graph/frame_graph.h"

#include <span>

namespace manylight {

struct PhysicalImage {
    gpu::Texture texture;
    ResourceState state;
};

struct PhysicalBuffer {
    gpu::Buffer buffer;
    ResourceState state;
};

/// Imports with the object's own description and state. It must live, at this address, until the frame has run.
ImageHandle importPhysical(FrameGraph& graph, const std::string& name, PhysicalImage& image);
BufferHandle importPhysical(FrameGraph& graph, const std::string& name, PhysicalBuffer& buffer);

/// The image of a resource as bytes, tightly packed rows. The image needs TRANSFER_SRC usage and defined content.
std::vector<std::byte> readPhysical(gpu::Device& device, PhysicalImage& image);
/// Replaces the image's content by bytes in the same order. The image needs TRANSFER_DST usage.
void writePhysical(gpu::Device& device, PhysicalImage& image, std::span<const std::byte> bytes);

}  // namespace manylight
