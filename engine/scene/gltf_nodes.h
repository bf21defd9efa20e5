// glTF nodes: transforms, and what hangs on them.
#pragma once

#include "engine/scene/gltf_accessor.h"
#include "engine/scene/import_options.h"
#include "engine/scene/raw_scene.h"

namespace manylight {

/// Walks the default scene and appends its meshes, lights and cameras. What the scene does not reach is counted.
void addGltfNodes(const GltfFile& gltf, const ImportOptions& options, RawScene& scene);

}  // namespace manylight
