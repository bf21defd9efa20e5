// Where two pictures differ, in false colour.
#pragma once

#include "apps/compare/inputs.h"
#include "engine/metrics/error.h"

namespace manylight {

/// Writes the signed relative error of each pixel's luminance y over the reference's Y, both divided by the
/// reference's mean luminance: (y - Y) / sqrt(Y² + 0.01), blue where the picture is darker, red where it is brighter,
/// light grey where both agree. `range` is the error at the scale's ends; empty: the 99th percentile of its size,
/// rounded up to 1, 2 or 5 times a power of ten. Not finite: magenta; masked out: dark grey. Returns the legend, one
/// line. Throws Error if the reference's mean luminance is not positive.
std::string writeDifference(const std::filesystem::path& path, const CompareInputs& inputs, const ErrorReport& error,
                            std::optional<double> range);

/// Writes FLIP's map in its colours, from black (0) to pale yellow (1). Returns the legend, one line.
std::string writeFlipMap(const std::filesystem::path& path, const CompareInputs& inputs, const FlipResult& flip);

}  // namespace manylight
