#include "engine/passes/tonemap.h"

#include "shaders/shared/bindings.h"

namespace manylight {

ImageHandle addTonemap(FrameGraph& graph, const SceneHandles& scene, ImageHandle sum, ImageHandle display, float scale,
                       uint32_t curve, uint32_t width, uint32_t height) {
    PassBuilder pass = graph.addPass("tonemap");
    readFrame(pass, scene, PipelineKind::Compute);
    pass.read(sum, Access::ComputeStorageRead, shared::kBindingRadianceSum);
    display = pass.write(display, Access::ComputeStorageWrite, shared::kBindingDisplay);
    pass.execute([push = shared::TonemapPush{scale, curve}, width, height](PassContext& context) {
        context.dispatch({.shader = "tonemap.comp", .group = gpu::imageGroup(context.tuning())}, width, height, push);
    });
    return display;
}

}  // namespace manylight
