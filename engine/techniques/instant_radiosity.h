// Instant radiosity, deferred (Keller 1997 with a G-buffer): light paths leave VPLs, every visible point gathers.
#pragma once

#include "engine/techniques/frame_inputs.h"

namespace manylight {

TechniqueResult declareInstantRadiosity(FrameGraph& graph, SceneHandles& scene, const FrameInputs& inputs);

}  // namespace manylight
