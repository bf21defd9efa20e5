// Opens any scene the engine reads: .obj, .gltf, .glb or a .json sidecar.
#pragma once

#include "engine/scene/import_options.h"
#include "engine/scene/scene.h"

#include <filesystem>

namespace manylight {

/// Reads, validates, repairs (counted in Scene::warnings) and normalises. Throws Error naming the file and the place.
Scene importScene(const std::filesystem::path& path, const ImportOptions& options = {});

}  // namespace manylight
