// Colour scales for pictures of numbers.
#pragma once

#include <glm/glm.hpp>

namespace manylight {

/// sRGB code values in [0, 1] of matplotlib's "magma" (SmithVanDerWalt2015), black over red to pale yellow: the
/// scale that FLIP is shown in. `value` is clamped to [0, 1].
glm::vec3 magma(float value);

/// sRGB code values in [0, 1] of Moreland's diverging scale (Moreland2009), blue over light grey to red. `value` is
/// clamped to [-1, 1]; 0 is the grey.
glm::vec3 blueGreyRed(float value);

}  // namespace manylight
