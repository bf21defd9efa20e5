// The crack test on a scene of the user's.
#pragma once

#include "apps/bench/stability_lab.h"

#include <filesystem>

namespace manylight {

/// From inside the largest closed parts of the scene, a million rays to their edges and corners: none may escape. From
/// the camera and random places, a million rays to all edges, beside Embree's robust mode: counted. Throws Error.
Findings crackTest(StabilityLab& lab, const std::filesystem::path& scene);

}  // namespace manylight
