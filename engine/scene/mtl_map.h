// The texture statements of MTL: options, then a file name.
#pragma once

#include "engine/scene/mtl.h"

namespace manylight {

/// Parses what follows the keyword. Empty, counted, if there is no file name. Options may follow it, as some programs
/// write them.
std::optional<MtlMap> parseMtlMap(std::string_view text, const std::string& place, Warnings& warnings);

}  // namespace manylight
