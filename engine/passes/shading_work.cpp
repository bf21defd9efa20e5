#include "engine/passes/shading_work.h"

#include "engine/core/check.h"

#include <algorithm>

namespace manylight {

// One iteration per light, a few per block of VPLs; with shadows, those of a ray on top.
static_assert(2 * shared::kMaxVplsPerDispatch < shared::kLoopBudget);
static_assert(200 * shared::kMaxShadowedVplsPerDispatch < shared::kLoopBudget);

std::vector<shared::ShadePush> shadingStretches(uint32_t lightCount, uint32_t vplCount, uint32_t limit,
                                                bool showEmission) {
    MANYLIGHT_CHECK(limit % shared::kVplPadding == 0u, "stretches of {}", limit);
    std::vector<shared::ShadePush> stretches;
    uint32_t light = 0;
    uint32_t vpl = 0;
    do {
        shared::ShadePush push{};
        push.firstLight = light;
        push.lightCount = std::min(limit, lightCount - light);
        light += push.lightCount;
        push.firstVpl = vpl;
        // VPLs in whole blocks of the padding, so that a stretch never starts inside a subgroup's block.
        const uint32_t room = (limit - push.lightCount) / shared::kVplPadding * shared::kVplPadding;
        if (light == lightCount) push.vplCount = std::min(room, vplCount - vpl);
        vpl += push.vplCount;
        push.showEmission = showEmission && stretches.empty() ? 1u : 0u;
        stretches.push_back(push);
    } while (light < lightCount || vpl < vplCount);
    return stretches;
}

uint32_t rowsPerDispatch(uint32_t width, uint32_t workPerPixel, uint32_t most, uint32_t rowStep) {
    const uint64_t workPerStep = uint64_t{std::max(width, 1u)} * std::max(workPerPixel, 1u) * rowStep;
    const uint64_t steps = std::clamp<uint64_t>(most / workPerStep, 1, (1u << 24) / rowStep);
    return static_cast<uint32_t>(steps) * rowStep;
}

}  // namespace manylight
