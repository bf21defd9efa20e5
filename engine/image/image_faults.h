// Faults of PNG and JPEG files that their decoder (stb_image 2.27) would not survive, or not cheaply.
#pragma once

#include <cstdint>
#include <span>

namespace manylight {

/// What is wrong, or nullptr. Looked for are chunks of a PNG that end behind the file, as the decoder takes their
/// length for the memory it needs, and Huffman tables of a JPEG with more than the 256 codes that there can be, as the
/// decoder writes past their end. All else is left to the decoder; other formats have no fault here.
const char* imageFault(std::span<const uint8_t> bytes);

}  // namespace manylight
