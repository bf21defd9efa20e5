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

void readVpls(PassBuilder& pass, const VplBuffers& vpls, PipelineKind kind) {
    const Access texel = kind == PipelineKind::Compute ? Access::ComputeTexelRead : Access::GraphicsTexelRead;
    pass.read(vpls.list, texel, shared::kBindingVplTexels).read(vpls.gloss, texel, shared::kBindingVplGloss);
}

}  // namespace manylight
