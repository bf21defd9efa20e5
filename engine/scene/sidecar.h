// JSON sidecar: names a scene file and gives it the camera, lights and settings that it lacks. Format: docs/scenes.md.
#pragma once

#include "engine/scene/import_options.h"
#include "engine/scene/raw_scene.h"

#include <filesystem>

namespace manylight {

/// The moment of the animation that a sidecar asks for, in seconds; none if it does not, or is none. Throws Error.
std::optional<double> savedMoment(const std::filesystem::path& path);

/// Reads the sidecar and the scene file it names. Throws Error with file and JSON path for unknown keys and bad values.
RawScene readSidecar(const std::filesystem::path& path, const ImportOptions& options);

}  // namespace manylight
