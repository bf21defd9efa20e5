// The crack test on a scene of the user's.
#pragma once

#include "apps/bench/stability/lab.h"

#include <filesystem>

namespace manylight {

/// From inside the largest closed parts of the scene, a million rays to their edges and corners, and as many to edges
/// that two triangles share: none may escape. As many to all edges and corners beside Embree's robust mode: counted.
/// Throws Error.
Findings crackTest(StabilityLab& lab, const std::filesystem::path& scene);

}  // namespace manylight
