#include "engine/passes/vpl_buffers.h"

#include "shaders/shared/bindings.h"
#include "shaders/shared/lights.h"
#include "shaders/shared/vpl_light.h"

namespace manylight {

uint32_t paddedVplCount(uint32_t vplCount) {
    return (vplCount + shared::kVplPadding - 1) / shared::kVplPadding * shared::kVplPadding;
}

VplBuffers createVplBuffers(FrameGraph& graph, const ScenePlan& plan, uint32_t vplCount) {
    const size_t count = paddedVplCount(vplCount);
    return {graph.createBuffer("VPLs", {count * sizeof(shared::LightData), VK_FORMAT_R32G32B32A32_SFLOAT}),
            graph.createBuffer("VPL gloss",
                               {(plan.glossy ? count : 1) * sizeof(shared::VplGloss), VK_FORMAT_R32G32B32A32_SFLOAT})};
}

PhysicalBuffer makeVplCopy(gpu::Device& device, uint32_t vplCount) {
    const VkDeviceSize bytes = paddedVplCount(vplCount) * sizeof(shared::LightData);
    return {gpu::Buffer(device, "VPL copy", {bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryKind::Readback}), {}};
}

void copyVplsToHost(FrameGraph& graph, BufferHandle list, PhysicalBuffer& copy) {
    const VkDeviceSize bytes = copy.buffer.size();
    PassBuilder pass = graph.addPass("vpl_copy");
    pass.read(list, Access::TransferRead);
    const BufferHandle target = pass.write(importPhysical(graph, "VPL copy", copy), Access::TransferWrite);
    pass.execute([=](PassContext& context) { context.copy(list, 0, bytes, target); });
    graph.addPass("vpl_readback").read(target, Access::HostRead).keep("the host reads the VPLs");
}

void readVpls(PassBuilder& pass, const VplBuffers& vpls, PipelineKind kind) {
    const Access texel = kind == PipelineKind::Compute ? Access::ComputeTexelRead : Access::GraphicsTexelRead;
    pass.read(vpls.list, texel, shared::kBindingVplTexels).read(vpls.gloss, texel, shared::kBindingVplGloss);
}

}  // namespace manylight
