#include "engine/math/projection.h"

#include <gtest/gtest.h>

namespace manylight {
namespace {

const glm::vec3 kOrigin{1.0f, 2.0f, 3.0f};
const glm::vec3 kForward = glm::normalize(glm::vec3(1.0f, -0.5f, 0.2f));
const glm::vec3 kUp = glm::normalize(glm::cross(glm::cross(kForward, glm::vec3(0, 1, 0)), kForward));

TEST(Projection, PointsOnAPixelsRayLandOnThatPixel) {
    const ViewAxes view = viewAxes(kOrigin, kForward, kUp, 0.8f, 1.5f);
    const glm::mat4 clip = clipFromWorld(view, 1e-3f, glm::vec2(0.0f));
    for (const glm::vec2 ndc : {glm::vec2(0, 0), glm::vec2(-1, 1), glm::vec2(0.3f, -0.7f)})
        for (const float t : {0.01f, 1.0f, 50.0f}) {
            const glm::vec3 point = view.origin + t * (view.forward + ndc.x * view.right + ndc.y * view.down);
            const glm::vec4 projected = clip * glm::vec4(point, 1.0f);
            EXPECT_NEAR(projected.x / projected.w, ndc.x, 2e-4f);  // 1e-6 of the coordinates, seen from t = 0.01
            EXPECT_NEAR(projected.y / projected.w, ndc.y, 2e-4f);
            EXPECT_NEAR(projected.z / projected.w, 1e-3f / t, 2e-4f);  // reversed depth
        }
}

TEST(Projection, YPointsDownAndXRight) {
    const ViewAxes view = viewAxes({}, {0, 0, -1}, {0, 1, 0}, 1.0f, 1.0f);
    EXPECT_GT(view.right.x, 0.0f);
    EXPECT_LT(view.down.y, 0.0f);
}

TEST(Projection, ShiftMovesThePictureByThatMuchNdc) {
    const ViewAxes view = viewAxes({}, {0, 0, -1}, {0, 1, 0}, 1.0f, 1.0f);
    const glm::vec4 point(0.1f, 0.2f, -2.0f, 1.0f);
    const glm::vec4 plain = clipFromWorld(view, 1e-3f, glm::vec2(0.0f)) * point;
    const glm::vec4 moved = clipFromWorld(view, 1e-3f, glm::vec2(0.25f, -0.5f)) * point;
    EXPECT_NEAR(moved.x / moved.w - plain.x / plain.w, 0.25f, 1e-6f);
    EXPECT_NEAR(moved.y / moved.w - plain.y / plain.w, -0.5f, 1e-6f);
}

}  // namespace
}  // namespace manylight
