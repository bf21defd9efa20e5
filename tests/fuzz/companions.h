// Files that lie beside a fuzzer's input, so that what the input refers to can exist.
#pragma once

#include <string>
#include <vector>

namespace manylight::fuzz {

struct Companion {
    std::string name;
    std::string content;
};

/// room.obj, room.mtl, triangle.gltf, triangle.bin, red.tga, and uses_input.obj, which uses the materials of input.mtl
/// by the names a, b, c, "two words" and none.
std::vector<Companion> companions();

}  // namespace manylight::fuzz
