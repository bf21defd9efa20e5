#include "engine/passes/accumulate.h"

#include "shaders/shared/bindings.h"

namespace manylight {
namespace {

void dispatchImage(PassBuilder& pass, const char* shader, bool starts, uint32_t width, uint32_t height) {
    pass.execute([shader, starts, width, height](PassContext& context) {
        context.dispatch({.shader = shader, .group = gpu::imageGroup(context.tuning()), .specialisation = {starts}},
                         width, height);
    });
}

}  // namespace

RunningSum addAccumulate(FrameGraph& graph, const SceneHandles& scene, ImageHandle radiance, RunningSum running,
                         bool isFirstFrame, uint32_t width, uint32_t height) {
    const Access access = isFirstFrame ? Access::ComputeStorageWrite : Access::ComputeStorageReadWrite;
    PassBuilder pass = graph.addPass("accumulate");
    readFrame(pass, scene, PipelineKind::Compute);
    pass.read(radiance, Access::ComputeStorageRead, shared::kBindingRadiance);
    running.sum = pass.write(running.sum, access, shared::kBindingRadianceSum);
    running.roundingError = pass.write(running.roundingError, access, shared::kBindingRoundingError);
    dispatchImage(pass, "accumulate.comp", isFirstFrame, width, height);
    return running;
}

ImageHandle addVariance(FrameGraph& graph, const SceneHandles& scene, ImageHandle radiance, ImageHandle sum,
                        ImageHandle squaredDeviations, bool isSecondFrame, uint32_t width, uint32_t height) {
    PassBuilder pass = graph.addPass("variance");
    readFrame(pass, scene, PipelineKind::Compute);
    pass.read(radiance, Access::ComputeStorageRead, shared::kBindingRadiance)
        .read(sum, Access::ComputeStorageRead, shared::kBindingRadianceSum);
    squaredDeviations =
        pass.write(squaredDeviations, isSecondFrame ? Access::ComputeStorageWrite : Access::ComputeStorageReadWrite,
                   shared::kBindingSquaredDeviations);
    dispatchImage(pass, "variance.comp", isSecondFrame, width, height);
    return squaredDeviations;
}

}  // namespace manylight
