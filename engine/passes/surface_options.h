// Specialisation constants 0 and 1 of every shader that looks up surfaces.
#pragma once

#include "engine/gpu/pipeline.h"
#include "engine/scene/scene_plan.h"

namespace manylight {

/// constant_id 0: kTextured, 1: kShadingNormals.
inline gpu::Specialisation surfaceOptions(const ScenePlan& plan) { return {plan.textured, plan.shadingNormals}; }

}  // namespace manylight
