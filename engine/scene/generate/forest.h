// A wood at night: a few kinds of trees, each of many thousand triangles, shown over and over, and lamps between them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace manylight {

struct ForestParameters {
    uint64_t triangleTarget = 5'000'000;  // shown, all trees together
    uint32_t treeTriangles = 10'000;      // of each kind of tree
    uint32_t kinds = 3;
    uint64_t seed = 1;
};

struct ForestFiles {
    std::vector<std::filesystem::path> written;
    uint64_t trianglesShown = 0;
    uint64_t trianglesStored = 0;
};

/// Writes folder/forest.gltf, folder/forest.bin and the sidecar folder/forest.json. Throws Error if that is impossible.
ForestFiles writeForest(const ForestParameters& parameters, const std::filesystem::path& folder);

}  // namespace manylight
