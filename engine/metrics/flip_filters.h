// The separable filters of FLIP: what an eye still resolves, and edges and points.
#pragma once

#include <cstddef>
#include <vector>

namespace manylight {

/// A plane of floats, row by row.
struct Plane {
    size_t width = 0;
    size_t height = 0;
    std::vector<float> values;

    Plane(size_t w, size_t h) : width(w), height(h), values(w * h) {}
    float* row(size_t y) { return &values[y * width]; }
    const float* row(size_t y) const { return &values[y * width]; }
};

/// Weights at distance 0, 1, ...; towards smaller coordinates they are the same, or negated in an odd filter.
struct HalfFilter {
    std::vector<float> weights;
    bool isOdd = false;
};

struct FlipFilters {
    HalfFilter luminance;
    HalfFilter redGreen;
    HalfFilter blueYellow[2];  // applied along rows and columns each, then summed
    HalfFilter gaussian;       // of the feature detector, with its derivatives
    HalfFilter edge;
    HalfFilter point;
};

/// Contrast sensitivity after Andersson2020, section 4.1.1, normalised as there; feature filters after section 4.2.
FlipFilters flipFilters(double pixelsPerDegree);

/// Convolution along rows or columns. Beyond the border the plane continues with its outermost values.
Plane filterRows(const Plane& plane, const HalfFilter& filter);
Plane filterColumns(const Plane& plane, const HalfFilter& filter);

}  // namespace manylight
