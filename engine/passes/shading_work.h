// The lights and VPLs of a frame cut into stretches, none longer than a dispatch or draw may take on.
#pragma once

#include "shaders/shared/vpl_light.h"

#include <cstdint>
#include <vector>

namespace manylight {

/// Lights first, then VPLs; every stretch has at most `limit` of both together. VPL stretches start at multiples
/// of shared::kVplPadding. There is at least one stretch, and only the first shows emission.
std::vector<shared::ShadePush> shadingStretches(uint32_t lightCount, uint32_t vplCount, uint32_t limit,
                                                bool showEmission);

}  // namespace manylight
