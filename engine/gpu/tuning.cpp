#include "engine/gpu/tuning.h"

#include "shaders/shared/bvh.h"

#include <algorithm>

namespace manylight::gpu {

const std::vector<Tunable>& tunables() {
    static const std::vector<Tunable> kTunables = {
        {"gather-threads",
         [](Tuning& t) -> uint32_t& { return t.gatherThreads; },
         {128, 32, 64, 256},
         "workgroup of the gather without rays"},
        {"pixels-per-invocation",
         [](Tuning& t) -> uint32_t& { return t.pixelsPerInvocation; },
         {0, 2, 4, 8},
         "pixels of a thread of that gather; 0: tried out on the first frames"},
        {"ray-threads",
         [](Tuning& t) -> uint32_t& { return t.rayThreads; },
         {128, 32, 64, 256},
         "workgroup of kernels that trace rays for pixels"},
        {"path-threads",
         [](Tuning& t) -> uint32_t& { return t.pathThreads; },
         {64, 32, 128, 256},
         "workgroup of kernels that trace light paths"},
        {"image-width",
         [](Tuning& t) -> uint32_t& { return t.imageWidth; },
         {16, 8, 32, 64},
         "workgroup of kernels that go through images, along x"},
        {"image-height", [](Tuning& t) -> uint32_t& { return t.imageHeight; }, {8, 16, 1, 2, 4}, "the same along y"},
        {"dispatch-parts",
         [](Tuning& t) -> uint32_t& { return t.dispatchParts; },
         {1, 4, 16},
         "a gather's dispatch takes on one in so many of the pixels that it might"},
        {"stack-in-registers",
         [](Tuning& t) -> uint32_t& { return t.traversal.stackInRegisters; },
         {1, 0},
         "where any-hit queries keep their stack"},
        {"nodes-any-hit",
         [](Tuning& t) -> uint32_t& { return t.traversal.nodesAnyHit; },
         {12, 4, 8, 16, 24},
         "nodes that a ray visits before its subgroup turns to leaves"},
        {"nodes-closest-hit",
         [](Tuning& t) -> uint32_t& { return t.traversal.nodesClosestHit; },
         {8, 4, 12, 16},
         "the same where the nearest triangle is asked for"},
        {"closest-in-registers",
         [](Tuning& t) -> uint32_t& { return t.traversal.closestInRegisters; },
         {1, 0},
         "where closest-hit queries keep their stack, if the tree is not too deep for registers"},
    };
    return kTunables;
}

uint32_t valueOf(const Tunable& tunable, const Tuning& tuning) {
    Tuning copy = tuning;
    return tunable.of(copy);
}

TraversalTuning forTreesOfDepth(TraversalTuning tuning, uint32_t depth) {
    tuning.closestRegisters = 0;
    if (tuning.closestInRegisters == 0) return tuning;
    // As few as will do: every step moves all of them.
    for (const uint32_t registers : {shared::kBvhRegisterStackSize, shared::kBvhShortStackSize})
        if (depth <= registers + 1) tuning.closestRegisters = registers;
    return tuning;
}

bool fits(const Tuning& tuning, const GroupLimits& limits) {
    const bool isKnown = std::ranges::all_of(tunables(), [&](const Tunable& tunable) {
        return std::ranges::find(tunable.values, valueOf(tunable, tuning)) != tunable.values.end();
    });
    const auto fitsInRow = [&](uint32_t threads) {
        return threads <= std::min(limits.threads, limits.threadsX) && threads % limits.subgroup == 0;
    };
    return isKnown && fitsInRow(tuning.gatherThreads) && fitsInRow(tuning.rayThreads) &&
           tuning.pathThreads <= std::min(limits.threads, limits.threadsX) && tuning.imageWidth <= limits.threadsX &&
           tuning.imageHeight <= limits.threadsY && tuning.imageWidth * tuning.imageHeight <= limits.threads;
}

}  // namespace manylight::gpu
