// Closed parts of a scene: connected triangles without a border.
#pragma once

#include "engine/scene/scene.h"

#include <vector>

namespace manylight {

/// The `most` largest ones, each a scene of its own in the same frame. Corners are the same where their positions have
/// the same bits; every edge must be there once in each direction.
std::vector<Scene> closedParts(const Scene& scene, size_t most);

/// An edge of exactly two triangles: its ends, and their third corners. Indices into Scene::vertices.
struct InnerEdge {
    uint32_t ends[2];
    uint32_t opposite[2];
};
std::vector<InnerEdge> innerEdges(const Scene& scene);

/// Positive where the counter-clockwise sides are outside.
double signedVolume(const Scene& closed);

}  // namespace manylight
