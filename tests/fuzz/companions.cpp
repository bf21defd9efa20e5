#include "tests/fuzz/companions.h"

#include <cstring>

namespace manylight::fuzz {
namespace {

constexpr char kRoom[] = R"(mtllib room.mtl
v -1 0 -1
v 1 0 -1
v 1 0 1
v -1 0 1
v -1 2 -1
v 1 2 -1
vt 0 0
vt 1 0
vt 1 1
usemtl floor
f 1/1 4/2 3/3 2/1
usemtl wall
f 1 2 6 5
)";

constexpr char kRoomMaterials[] = "newmtl floor\nKd 0.7 0.6 0.5\nmap_Kd red.tga\nnewmtl wall\nKd 0.5 0.5 0.5\n";

constexpr char kUsesInput[] = R"(mtllib input.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
vt 0 0
vt 1 0
vt 0 1
usemtl a
f 1/1 2/2 3/3
usemtl b
f 1/1 2/2 4/3
usemtl c
f 1/1 3/2 4/3
usemtl two words
f 2/1 3/2 4/3
usemtl
f 3/1 2/2 4/3
)";

constexpr char kTriangle[] = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
"nodes": [{"mesh": 0}, {"translation": [0, 0, 3], "extensions": {"KHR_lights_punctual": {"light": 0}}}],
"extensionsUsed": ["KHR_lights_punctual"],
"extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 5}]}},
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
"bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"uri": "triangle.bin", "byteLength": 36}]})";

/// Three corners, then numbers that serve as anything else: 256 bytes in all.
std::string triangleBytes() {
    const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::string bytes(sizeof corners, '\0');
    std::memcpy(bytes.data(), corners, sizeof corners);
    while (bytes.size() < 256) bytes += static_cast<char>(bytes.size() % 3);
    return bytes;
}

/// One red texel.
std::string redTga() { return {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 24, 32, 0, 0, '\xff'}; }

}  // namespace

std::vector<Companion> companions() {
    return {{"room.obj", kRoom},          {"room.mtl", kRoomMaterials},      {"uses_input.obj", kUsesInput},
            {"triangle.gltf", kTriangle}, {"triangle.bin", triangleBytes()}, {"red.tga", redTga()}};
}

}  // namespace manylight::fuzz
