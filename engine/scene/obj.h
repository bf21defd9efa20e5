// Wavefront OBJ with MTL.
#pragma once

#include "engine/scene/raw_scene.h"

#include <filesystem>

namespace manylight {

/// Reads faces of any size with positive and negative indices, groups, objects, usemtl and several mtllibs. Statements
/// that cannot be used are counted with their line in RawScene::warnings. Throws Error if the file is no OBJ text.
RawScene readObj(const std::filesystem::path& path);

}  // namespace manylight
