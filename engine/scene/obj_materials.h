// MTL files: the materials that an OBJ file names.
#pragma once

#include "engine/scene/raw_scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace manylight {

/// Fills `scene.materials` with one material per name, in that order; paths are relative to the MTL file. Missing files
/// and undefined materials are counted and leave a grey Lambertian of 0.8. How MTL's Phong model becomes a Material is
/// told in docs/scenes.md.
void readObjMaterials(const std::filesystem::path& folder, const std::vector<std::string>& libraries,
                      const std::vector<std::string>& names, RawScene& scene);

}  // namespace manylight
