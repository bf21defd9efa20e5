// What a texture is on average.
#pragma once

#include "engine/scene/scene.h"

namespace manylight {

/// Mean of the texels' colour, linear; white for a texture without texels.
glm::dvec3 meanOfTexture(const Texture& texture);

}  // namespace manylight
