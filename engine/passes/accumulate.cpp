#include "engine/passes/accumulate.h"

#include "shaders/shared/bindings.h"
#include "shaders/shared/tonemap.h"

namespace manylight {

ImageHandle addAccumulate(FrameGraph& graph, const SceneHandles& scene, ImageHandle radiance, ImageHandle sum,
                          bool isFirstFrame, uint32_t width, uint32_t height) {
    PassBuilder pass = graph.addPass("accumulate");
    readFrame(pass, scene, PipelineKind::Compute);
    pass.read(radiance, Access::ComputeStorageRead, shared::kBindingRadiance);
    sum = pass.write(sum, isFirstFrame ? Access::ComputeStorageWrite : Access::ComputeStorageReadWrite,
                     shared::kBindingRadianceSum);
    pass.execute([isFirstFrame, width, height](PassContext& context) {
        context.dispatch({.shader = "accumulate.comp",
                          .groupWidth = shared::kImageGroupWidth,
                          .groupHeight = shared::kImageGroupHeight,
                          .specialisation = {isFirstFrame}},
                         width, height);
    });
    return sum;
}

}  // namespace manylight
