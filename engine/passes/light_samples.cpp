#include "engine/passes/light_samples.h"

#include "shaders/shared/bindings.h"
#include "shaders/shared/lights.h"
#include "shaders/shared/vpl_emission.h"

#include <algorithm>

namespace manylight {

LightList addLightSamples(FrameGraph& graph, const SceneHandles& scene, uint32_t deltaLightCount,
                          uint32_t lightSampleCount) {
    const uint32_t count = deltaLightCount + lightSampleCount;
    LightList list{graph.createBuffer("lights", {std::max(count, 1u) * sizeof(shared::LightData)}), count};
    PassBuilder pass = graph.addPass("light_samples");
    readFrame(pass, scene, PipelineKind::Compute);
    pass.read(scene.emitters, Access::ComputeStorageRead, shared::kBindingEmitters);
    list.lights = pass.write(list.lights, Access::ComputeStorageWrite, shared::kBindingLights);
    pass.execute([count](PassContext& context) {
        context.dispatch({.shader = "light_samples.comp", .groupWidth = shared::kEmissionGroupSize}, count);
    });
    return list;
}

}  // namespace manylight
