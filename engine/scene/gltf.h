// glTF 2.0: .gltf with external or embedded buffers, .glb.
#pragma once

#include "engine/scene/import_options.h"
#include "engine/scene/raw_scene.h"

#include <filesystem>

namespace manylight {

/// Reads the default scene in its rest pose, or as `options` say. Throws Error naming the file and the JSON path for
/// anything out of range; what the engine has no use for (points and lines, ...) is counted in RawScene::warnings.
RawScene readGltf(const std::filesystem::path& path, const ImportOptions& options = {});

}  // namespace manylight
