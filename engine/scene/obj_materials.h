// MTL files: the materials that an OBJ file names.
#pragma once

#include "engine/scene/raw_scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace manylight {

/// Fills `scene.materials` with one material per name, in that order: Kd (grey 0.8 if missing), Ke as radiance, map_Kd
/// with a path relative to the MTL file. Missing files and undefined materials are counted and leave the default.
void readObjMaterials(const std::filesystem::path& folder, const std::vector<std::string>& libraries,
                      const std::vector<std::string>& names, RawScene& scene);

}  // namespace manylight
