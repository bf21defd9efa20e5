// Closed bodies of a generated scene, one by one.
#pragma once

#include "engine/scene/scene.h"

namespace manylight::stability {

/// Closed, star-shaped solids of the generated courtyard: boxes, columns, balls. The first `count` of those whose
/// every face is seen from the middle of the bounds.
std::vector<Scene> courtyardSolids(size_t count);

}  // namespace manylight::stability
