// Instant radiosity, forward: the comparison of the original paper, with and without a depth pre-pass.
#pragma once

#include "engine/techniques/frame_inputs.h"

namespace manylight {

TechniqueResult declareForwardRadiosity(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs);

}  // namespace manylight
