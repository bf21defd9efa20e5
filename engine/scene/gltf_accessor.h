// Numbers behind glTF accessors: any component type, interleaved, normalised, sparse.
#pragma once

#include "engine/scene/gltf_container.h"

#include <tiny_gltf.h>

#include <vector>

namespace manylight {

/// A checked file: the container's buffers and tinygltf's view of the JSON.
struct GltfFile {
    GltfContainer container;
    tinygltf::Model model;
    size_t mostElements = 0;  // vertices, triangles or drawn primitives that the scene may get from a file of this size
    Warnings warnings;        // of the file as a whole
    size_t viewCount = 0;     // an accessor whose bufferView is not below has no data: zeros, unless sparse
};

/// Throws Error if `count` is more than GltfFile::mostElements; `place` and `what` are for its message.
void checkGltfAmount(const GltfFile& gltf, size_t count, std::string_view place, std::string_view what);

/// All components in element order; normalised integers as [0, 1] or [-1, 1]. Throws Error if a buffer is missing.
std::vector<double> readGltfNumbers(const GltfFile& gltf, int accessor);

/// An accessor of indices. Throws Error if a buffer is missing.
std::vector<uint32_t> readGltfIndices(const GltfFile& gltf, int accessor);

/// Bytes of a buffer view. Throws Error if its buffer is missing or too short.
std::pair<const uint8_t*, size_t> gltfViewBytes(const GltfFile& gltf, int bufferView);

}  // namespace manylight
