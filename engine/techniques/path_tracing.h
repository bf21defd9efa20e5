// The reference: a progressive path tracer (Kajiya 1986) that shares surfaces and rays with the VPL techniques, and none
// of their estimators.
#pragma once

#include "engine/techniques/frame_inputs.h"

namespace manylight {

TechniqueResult declarePathTracing(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs);

}  // namespace manylight
