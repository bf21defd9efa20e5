// One displayed picture as FLIP sees it, and the difference of two.
#pragma once

#include "engine/metrics/flip_filters.h"

namespace manylight {

/// Display-linear RGB in [0, 1], one plane a channel.
struct DisplayPlanes {
    Plane red;
    Plane green;
    Plane blue;
};

/// CIELAB after the eye's blur, with Hunt's adjustment of the chroma, and the strength of edges and points.
struct Perceived {
    Plane lightness;
    Plane a;
    Plane b;
    Plane edge;
    Plane point;
};

Perceived perceive(const DisplayPlanes& picture, const FlipFilters& filters);

/// LDR-FLIP of every pixel, 0 to 1 (Andersson2020, section 4).
Plane flipDifference(const Perceived& test, const Perceived& reference);

}  // namespace manylight
