// What the renderer may take for granted of any Scene.
#pragma once

#include "engine/scene/scene.h"

namespace manylight::fuzz {

/// Throws BugError if an index is out of range, a number is not finite or a vector is not of the length it promises.
void checkScene(const Scene& scene);

}  // namespace manylight::fuzz
