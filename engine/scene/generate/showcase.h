// A furnished room at dusk that needs everything the engine can leave out, to measure what leaving out is worth.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace manylight {

struct ShowcaseParameters {
    uint64_t seed = 1;  // of wood, books, leaves
};

struct ShowcaseFiles {
    std::vector<std::filesystem::path> written;
    uint64_t trianglesShown = 0;
};

/// Writes folder/showcase.json and, in folder/showcase/, showcase.gltf with its buffer, textures and environment map,
/// each atomically and the sidecar last. Throws Error if that is impossible.
ShowcaseFiles writeShowcase(const ShowcaseParameters& parameters, const std::filesystem::path& folder);

}  // namespace manylight
