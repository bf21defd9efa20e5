// Closed parts of a scene: connected triangles without a border.
#pragma once

#include "engine/scene/scene.h"

#include <vector>

namespace manylight {

/// The `most` largest ones, each a scene of its own in the same frame. Corners are the same where their positions have
/// the same bits; every edge must be there once in each direction.
std::vector<Scene> closedParts(const Scene& scene, size_t most);

/// Positive where the counter-clockwise sides are outside.
double signedVolume(const Scene& closed);

}  // namespace manylight
