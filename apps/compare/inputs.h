// What is compared: two pictures of one size and kind.
#pragma once

#include "apps/compare/compare.h"
#include "engine/core/report.h"

namespace manylight {

struct CompareInputs {
    Image test;  // three channels, linear
    Image reference;
    std::optional<Mask> mask;
    bool isDisplay = false;  // decoded from sRGB: PNG and the like
    bool isColour = true;    // not normals, positions or the like
    Warnings warnings;
};

/// Reads and crops. Throws Error for files that are missing or do not go together.
CompareInputs readInputs(const CompareOptions& options);

}  // namespace manylight
