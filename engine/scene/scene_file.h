// Which kind of scene file a path names, by its extension.
#pragma once

#include "engine/scene/import_options.h"
#include "engine/scene/raw_scene.h"

#include <filesystem>

namespace manylight {

enum class SceneFileKind : uint8_t { Obj, Gltf, Sidecar, Unknown };

SceneFileKind sceneFileKind(const std::filesystem::path& path);

/// Reads a scene file of any kind. With `placesOnly` only what an animation moves is sure to be there. Throws Error; an unknown extension lists the known ones.
RawScene readSceneFile(const std::filesystem::path& path, const ImportOptions& options = {});

}  // namespace manylight
