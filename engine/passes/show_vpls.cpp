#include "engine/passes/show_vpls.h"

#include "shaders/shared/bindings.h"
#include "shaders/shared/show.h"

namespace manylight {

ImageHandle addShowVpls(FrameGraph& graph, const SceneHandles& scene, BufferHandle vpls, uint32_t vplCount,
                        ImageHandle radiance, ImageHandle depth, float radius, float brightness) {
    PassBuilder pass = graph.addPass("show_vpls");
    readFrame(pass, scene, PipelineKind::Graphics);
    pass.read(vpls, Access::GraphicsStorageRead, shared::kBindingVpls).read(depth, Access::DepthRead);
    radiance = pass.write(radiance, Access::ColorWrite);
    const shared::ShowVplsPush push{radius, brightness};
    pass.execute([push, vplCount](PassContext& context) {
        context.draw({.vertexShader = "show_vpls.vert",
                      .fragmentShader = "show_vpls.frag",
                      .depthCompare = VK_COMPARE_OP_GREATER},
                     vplCount * 6, push);
    });
    return radiance;
}

}  // namespace manylight
