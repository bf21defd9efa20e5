// An arcaded courtyard of two storeys by lantern light: the project's own larger scene.
#pragma once

#include <string_view>

#include "engine/scene/generate/generated_scene.h"

namespace manylight {

enum class CourtyardLight { Point, Sun, Sky, Area };

struct CourtyardParameters {
    uint32_t triangleTarget = 65'000;  // met exactly or one short
    uint32_t depth = 2;                // 1 to 6: rows of columns in each gallery, trees, ivy: surfaces behind a pixel
    uint64_t seed = 1;                 // arrangement, colours of single stones, leaves
    CourtyardLight light = CourtyardLight::Point;
};

/// The name of a light on the command line: point, sun, sky, area.
CourtyardLight courtyardLightFrom(std::string_view name);

/// Metres, y up, the court around the origin. Detail of the building grows with the triangle target and leaves fill
/// what is left. Throws a usage Error where the target is too small for the rows of columns, or parameters are out of
/// range.
GeneratedScene generateCourtyard(const CourtyardParameters& parameters);

}  // namespace manylight
