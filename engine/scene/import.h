// Opens any scene the engine reads: .obj, .gltf, .glb, a .json sidecar, or a generated scene.
#pragma once

#include "engine/scene/scene.h"

#include <filesystem>

namespace manylight {

/// Reads, validates, repairs (counted in Scene::warnings) and normalises. Throws Error naming the file and the place.
Scene importScene(const std::filesystem::path& path);

}  // namespace manylight
