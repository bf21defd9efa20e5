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

/// Rows of a dispatch that does `workPerPixel` for each of `width` pixels a row, `most` in all: a multiple of
/// `rowStep`, at least one of it.
uint32_t rowsPerDispatch(uint32_t width, uint32_t workPerPixel, uint32_t most, uint32_t rowStep);

}  // namespace manylight
