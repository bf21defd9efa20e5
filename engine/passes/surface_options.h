// Specialisation constants of every shader that looks up surfaces; see shaders/lib/surface.glsl.
#pragma once

#include "engine/gpu/pipeline.h"
#include "engine/scene/scene_plan.h"

namespace manylight {

/// Constants 0 to 9. What a pass appends is numbered from 10.
inline gpu::Specialisation surfaceOptions(const ScenePlan& plan) {
    const uint32_t instances = !plan.instanced ? 0u : plan.stretched ? 2u : 1u;
    const uint32_t textures = !plan.textured ? 0u : plan.mipmapped ? 2u : 1u;
    return {textures,           plan.shadingNormals,   plan.glossy, plan.alphaTested, plan.normalMapped,
            plan.vertexColours, plan.emissionTextured, plan.uvSets, plan.culled,      instances};
}

/// Constants 20 and 21, after the pass's own: see shaders/lib/environment.glsl and emitters.glsl.
inline gpu::Specialisation withEmitterOptions(gpu::Specialisation constants, const ScenePlan& plan) {
    constants.resize(20);
    constants.insert(constants.end(), {plan.environmentMapped, plan.manyEmitters});
    return constants;
}

}  // namespace manylight
