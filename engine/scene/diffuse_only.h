// Every surface a Lambertian: for comparison with renderers and results that know no others.
#pragma once

#include "engine/scene/scene.h"

namespace manylight {

/// Reduces every material to a two-sided, opaque Lambertian of its albedo and albedo texture; emission, its texture and
/// vertex colours stay. What was unlit is lit. Textures that no material uses any more are dropped.
Scene diffuseOnly(Scene scene);

}  // namespace manylight
