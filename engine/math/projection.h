// The pinhole's matrices, in Vulkan's clip space (y down, depth 0 at infinity's far side: reversed).
#pragma once

#include <glm/glm.hpp>

namespace manylight {

/// A view as the shaders want it: axes scaled so that direction = forward + x * right + y * down for x, y in [-1, 1].
struct ViewAxes {
    glm::vec3 origin{0.0f};
    glm::vec3 right{0.0f};
    glm::vec3 down{0.0f};
    glm::vec3 forward{0.0f};
};

/// `forward` and `up` unit and perpendicular; `verticalFov` in radians; `aspect` = width / height.
ViewAxes viewAxes(glm::vec3 origin, glm::vec3 forward, glm::vec3 up, float verticalFov, float aspect);

/// Clip-space matrix with reversed, infinite depth: 1 at the near plane, towards 0 far away; `near` > 0.
/// `shift` moves the picture by that much of NDC: a sub-pixel offset of the sample.
glm::mat4 clipFromWorld(const ViewAxes& view, float near, glm::vec2 shift);

}  // namespace manylight
