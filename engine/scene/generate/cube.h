// The first scene that the seed of this project could show: a cube as a user would meet it.
#pragma once

#include "engine/scene/generate/generated_scene.h"

namespace manylight {

/// A unit cube of six quads in groups, with usemtl but neither its material file nor normals: every face falls back to
/// the default material. The sidecar puts the camera and a point light inside, so that the cube is a closed room.
GeneratedScene generateCube();

}  // namespace manylight
