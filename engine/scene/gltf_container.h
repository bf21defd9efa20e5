// The outer shape of a glTF file: JSON and binary data, before any meaning.
#pragma once

#include "engine/core/report.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace manylight {

/// Bytes of one entry of "buffers", or why there are none.
struct GltfBuffer {
    std::vector<uint8_t> bytes;
    std::string fault;
};

struct GltfContainer {
    std::string file;  // for messages
    std::filesystem::path folder;
    Json json;
    std::vector<uint8_t> binaryChunk;
    std::vector<GltfBuffer> buffers;
    size_t byteCount = 0;  // of the file and of its buffers
};

/// Opens .gltf or .glb. Throws Error for a broken container or JSON.
GltfContainer openGltf(const std::filesystem::path& path, Warnings& warnings);

/// Fills `buffers` from the binary chunk, data URIs and files. Those that cannot be read get a fault and a warning: an
/// accessor that needs one is an error, an unused one is not. To be called once the JSON is checked.
void loadGltfBuffers(GltfContainer& gltf, Warnings& warnings);

/// Bytes behind a data URI or a file beside the glTF file. Throws Error.
std::vector<uint8_t> readGltfUri(const GltfContainer& gltf, const std::string& uri);

}  // namespace manylight
