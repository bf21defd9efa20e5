// MTL text made explicit: what tinyobjloader misreads without a word, or does not tell, is written out for it.
#pragma once

#include "engine/core/report.h"

#include <string>
#include <string_view>

namespace manylight {

/// Says that the material has the statement: the library keeps what it does not know in material_t::unknown_parameter.
inline constexpr std::string_view kStatedPrefix = "stated_";

/// The text with keywords spelled as the library does, whole and finite numbers, "stated_Kd 1" beside Kd and so on for
/// all numbers and colours, and texture options as explicitMap writes them. What is left out is counted with file and
/// line.
std::string explicitMtl(std::string_view text, const std::string& file, Warnings& warnings);

/// What follows the keyword of a texture: all options that are read, each with all its numbers, then the file name.
/// Empty, counted, if there is no file name.
std::string explicitMap(std::string_view text, const std::string& place, Warnings& warnings);

/// A finite number as the library reads it back finite.
std::string explicitNumber(double number);

}  // namespace manylight
