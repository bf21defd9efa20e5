// The area that light reaches: what bounds of the geometry term are relative to.
#pragma once

#include "shaders/shared/lights.h"

#include <optional>
#include <span>

namespace manylight {

/// Area over which the light of a scene is spread, from where its light paths leave VPLs; dark ones do not count. Half
/// of the VPLs lie where fewer of them share an area, half where more do: a large ground that little light meets, or a
/// bright spot, does not move it. In the square of the unit of `vpls`, to a quarter of an octave, which rounding hardly
/// turns. Empty for fewer VPLs than can tell.
std::optional<double> litArea(std::span<const shared::LightData> vpls);

}  // namespace manylight
