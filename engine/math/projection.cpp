#include "engine/math/projection.h"

#include <cmath>

namespace manylight {

ViewAxes viewAxes(glm::vec3 origin, glm::vec3 forward, glm::vec3 up, float verticalFov, float aspect) {
    const float halfHeight = std::tan(0.5f * verticalFov);
    return {origin, glm::cross(forward, up) * (halfHeight * aspect), -up * halfHeight, forward};
}

glm::mat4 clipFromWorld(const ViewAxes& view, float near, glm::vec2 shift) {
    // Rows of the linear map: x and y of NDC times depth, the constant near plane, and the depth along the axis.
    const glm::vec3 x = view.right / glm::dot(view.right, view.right);
    const glm::vec3 y = view.down / glm::dot(view.down, view.down);
    const glm::vec3 w = view.forward / glm::dot(view.forward, view.forward);
    const glm::vec3 xShifted = x + shift.x * w;
    const glm::vec3 yShifted = y + shift.y * w;
    const glm::mat4 rows(glm::vec4(xShifted, -glm::dot(xShifted, view.origin)),
                         glm::vec4(yShifted, -glm::dot(yShifted, view.origin)), glm::vec4(0.0f, 0.0f, 0.0f, near),
                         glm::vec4(w, -glm::dot(w, view.origin)));
    return glm::transpose(rows);
}

}  // namespace manylight
