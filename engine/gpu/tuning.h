// What makes kernels faster on one device and slower on another, and shows in no picture.
#pragma once

#include "shaders/shared/workgroups.h"

#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace manylight::gpu {

/// Of the traversal in shaders/lib/bvh.glsl.
struct TraversalTuning {
    uint32_t stackInRegisters = 1;  // of any-hit queries; 0: in memory
    uint32_t nodesAnyHit = 12;      // that an invocation visits before it tests the triangles of a leaf at the latest
    uint32_t nodesClosestHit = 8;
    uint32_t closestInRegisters = 1;  // the stack of closest-hit queries, where the tree is not too deep for that
    uint32_t closestRegisters = 0;    // how many words of it then are; no tunable, see forTreesOfDepth()
    auto operator<=>(const TraversalTuning&) const = default;
};

/// The default is what was found on a software driver of 8 lanes.
struct Tuning {
    uint32_t gatherThreads = 128;      // a workgroup of the gather without rays, which shades a tile of pixels
    uint32_t rayThreads = 128;         // the same of kernels that trace rays for pixels
    uint32_t pathThreads = 64;         // a workgroup of those that trace light paths
    uint32_t imageWidth = 16;          // a workgroup of those that go through images: threads along x
    uint32_t imageHeight = 8;          // and along y
    uint32_t pixelsPerInvocation = 0;  // of the gather without rays; 0: tried out on the first frames
    uint32_t dispatchParts = 1;        // a gather's dispatch takes on this part of the pixels that it might
    TraversalTuning traversal;
    bool operator==(const Tuning&) const = default;
};

/// What of it suits the scene: rays through trees with at most so many nodes on their longest way down.
TraversalTuning forTreesOfDepth(TraversalTuning tuning, uint32_t depth);

/// Of one number in a Tuning: what files and tables call it, and the values it may have, the default first.
struct Tunable {
    const char* name;
    uint32_t& (*of)(Tuning& tuning);
    std::vector<uint32_t> values;
    const char* what;
};
const std::vector<Tunable>& tunables();
uint32_t valueOf(const Tunable& tunable, const Tuning& tuning);

/// What of a device bounds workgroups.
struct GroupLimits {
    uint32_t threads = 0;   // of a workgroup in all
    uint32_t threadsX = 0;  // along x
    uint32_t threadsY = 0;  // along y
    uint32_t subgroup = 0;  // lanes; full subgroups divide a workgroup
};
/// Whether the device can run kernels so, and every value is one of its tunable's.
bool fits(const Tuning& tuning, const GroupLimits& limits);

/// Threads of a compute kernel that run together, as the pixels or items that they work on lie.
struct Workgroup {
    uint32_t width = 1;
    uint32_t height = 1;
    bool isTile = false;  // its threads lie along x alone: see shaders/lib/tile.glsl
};
inline Workgroup rowOf(uint32_t threads) { return {threads, 1, false}; }
inline Workgroup tileOf(uint32_t threads) { return {shared::tileWidth(threads), shared::tileHeight(threads), true}; }
inline Workgroup imageGroup(const Tuning& tuning) { return {tuning.imageWidth, tuning.imageHeight, false}; }

}  // namespace manylight::gpu
