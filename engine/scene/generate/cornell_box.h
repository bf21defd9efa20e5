// The Cornell box from its published measurements.
#pragma once

#include "engine/scene/generate/generated_scene.h"

namespace manylight {

/// Geometry in millimetres and camera: Cornell University Program of Computer Graphics, "Cornell Box Data",
/// https://www.graphics.cornell.edu/online/box/data.html. The measured spectra are replaced by the linear RGB
/// reflectances and the warm light of "CornellBox-Original" in the McGuire Computer Graphics Archive (Williams College,
/// 2011). The light lies in the plane of the ceiling, which is therefore cut around it.
GeneratedScene generateCornellBox();

}  // namespace manylight
