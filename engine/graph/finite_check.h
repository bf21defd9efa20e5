// Looks for numbers that are none in what passes wrote.
#pragma once

#include "engine/graph/execute.h"

#include <optional>

namespace manylight {

struct NonFinite {
    std::string pass;
    std::string resource;
    uint64_t texels = 0;  // with a component that is infinite or no number
    uint32_t x = 0;       // of the first one
    uint32_t y = 0;
};

/// The first image among `dumped`, in the order of the passes, that holds such a texel. Told by their bits, as a
/// compiler may take comparisons of floats for granted. Images of integers hold none.
std::optional<NonFinite> findNonFinite(const std::vector<DumpedImage>& dumped);

}  // namespace manylight
