// What follows from the declarations: which passes live, which barriers stand before each, what shares memory.
#pragma once

#include "engine/graph/frame_graph.h"

namespace manylight {

struct Barrier {
    uint32_t resource = kNoIndex;
    Dependency dependency;
};

/// A pass that runs. All its barriers go into one vkCmdPipelineBarrier2 before it; with none, the call is left out.
struct LivePass {
    uint32_t pass = kNoIndex;
    std::vector<Barrier> barriers;
};

/// What the live passes make of a resource. One that no live pass touches has `firstPass == kNoIndex`.
struct CompiledResource {
    VkImageUsageFlags imageUsage = 0;
    VkBufferUsageFlags bufferUsage = 0;
    uint32_t firstPass = kNoIndex;  // index into CompiledGraph::passes
    uint32_t lastPass = kNoIndex;   // that of the last live pass for a kept resource: the caller reads it afterwards
    uint32_t slot = kNoIndex;       // of a transient
    ResourceState finalState;       // of an imported resource, to be stored by its owner
};

/// One physical image or buffer that transients of equal description take in turn.
struct PhysicalSlot {
    ResourceKind kind = ResourceKind::Image;
    ImageDesc image;
    BufferDesc buffer;
    VkImageUsageFlags imageUsage = 0;  // of all its owners
    VkBufferUsageFlags bufferUsage = 0;
    uint32_t lastPass = kNoIndex;  // of its last owner
    ResourceState finalState;      // to be stored with the physical resource, for the next frame
};

struct CompiledGraph {
    std::vector<LivePass> passes;  // in execution order
    std::vector<uint32_t> culled;  // indices into FrameGraph::passes(), ascending
    std::vector<CompiledResource> resources;
    std::vector<PhysicalSlot> slots;
};

}  // namespace manylight
