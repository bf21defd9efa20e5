#include "engine/passes/frame_status.h"

#include <cstring>

namespace manylight {

PhysicalBuffer makeStatusBuffer(gpu::Device& device) {
    constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    return {gpu::Buffer(device, "status", {sizeof(shared::FrameStatus), kUsage, gpu::MemoryKind::Readback}), {}};
}

void addStatusReset(FrameGraph& graph, SceneHandles& scene) {
    PassBuilder pass = graph.addPass("status_reset");
    scene.status = pass.write(scene.status, Access::TransferWrite);
    pass.execute([status = scene.status](PassContext& context) { context.fill(status, 0); });
}

void addStatusReadback(FrameGraph& graph, SceneHandles& scene) {
    graph.addPass("status_readback").read(scene.status, Access::HostRead).keep("the host reads the counters");
}

shared::FrameStatus readStatus(const PhysicalBuffer& status) {
    shared::FrameStatus counters;
    std::memcpy(&counters, status.buffer.mapped(), sizeof(counters));
    return counters;
}

}  // namespace manylight
