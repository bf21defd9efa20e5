// Where the camera stands, in the scene's own units, as a sidecar writes it.
#pragma once

#include "engine/scene/scene.h"

namespace manylight {

struct CameraPose {
    glm::dvec3 origin{0.0};
    glm::dvec3 target{0.0, 0.0, -1.0};  // looked at, and turned about; not the origin
    glm::dvec3 up{0.0, 1.0, 0.0};       // roughly
    double fovDegrees = 45.0;           // vertical
};

/// The target is as far away as the scene's middle.
CameraPose poseOf(const Camera& camera, const SceneFrame& frame);

/// As the importer makes it of the JSON, to the bit.
Camera cameraOf(const CameraPose& pose, const SceneFrame& frame);

/// A sidecar's "camera"; its numbers are exact.
Json toJson(const CameraPose& pose, glm::uvec2 resolution);

}  // namespace manylight
