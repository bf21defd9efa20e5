// JSON sidecar: names a scene file and gives it the camera, lights and settings that it lacks. Format: docs/scenes.md.
#pragma once

#include "engine/scene/import_options.h"
#include "engine/scene/raw_scene.h"

#include <filesystem>

namespace manylight {

/// Reads the sidecar and the scene file it names. Throws Error with file and JSON path for unknown keys and bad values.
RawScene readSidecar(const std::filesystem::path& path, const ImportOptions& options);

}  // namespace manylight
