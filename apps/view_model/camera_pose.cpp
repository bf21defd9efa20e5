#include "apps/view_model/camera_pose.h"

#include "engine/core/check.h"
#include "engine/scene/normalise_parts.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

Json vectorJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

CameraPose poseOf(const Camera& camera, const SceneFrame& frame) {
    const double unit = std::ldexp(1.0, frame.exponent);
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.forward));
    // The frame's origin is the middle of the scene.
    const double distance = std::max(-glm::dot(glm::dvec3(camera.origin), forward), 0.1);
    CameraPose pose;
    pose.origin = frame.center + unit * glm::dvec3(camera.origin);
    pose.target = pose.origin + unit * distance * forward;
    pose.up = glm::dvec3(camera.up);
    pose.fovDegrees = glm::degrees(double{camera.verticalFov});
    return pose;
}

Camera cameraOf(const CameraPose& pose, const SceneFrame& frame) {
    RawScene raw;
    RawCamera& source = raw.cameras.emplace_back();
    source.name = "view";
    source.origin = pose.origin;
    source.forward = pose.target - pose.origin;
    source.up = pose.up;
    source.verticalFov = glm::radians(pose.fovDegrees);
    Scene scene;
    scene.frame = frame;
    convertCameras(raw, scene);
    MANYLIGHT_CHECK(scene.cameras.size() == 1u, "a pose that is no camera");
    return scene.cameras.front();
}

Json toJson(const CameraPose& pose, glm::uvec2 resolution) {
    return {{"origin", vectorJson(pose.origin)},
            {"target", vectorJson(pose.target)},
            {"up", vectorJson(pose.up)},
            {"fov_y_deg", pose.fovDegrees},
            {"width", resolution.x},
            {"height", resolution.y}};
}

}  // namespace manylight
