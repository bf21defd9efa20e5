// The one way from what an importer read to a Scene: repairs, the normalised frame, defaults, the import report.
#pragma once

#include "engine/scene/raw_scene.h"

namespace manylight {

/// Drops triangles that cannot be used and repairs normals, texture coordinates, albedos and emission (all counted in
/// Scene::warnings), moves the centre of the bounds to the origin, scales by a power of two so that the diagonal is in
/// [1, 2), turns rectangular lights into triangles and adds a camera and a light where there is none.
/// A change of the file's unit by a power of two changes SceneFrame::exponent and nothing else.
Scene normalise(RawScene&& raw);

}  // namespace manylight
