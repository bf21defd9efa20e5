#include "apps/view_model/camera_motion.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

constexpr double kTurnPerHeight = 2.0;  // radians for a drag over the window's height
constexpr double kSpeedPerNotch = 1.25;
constexpr double kZoomPerNotch = 0.9;
constexpr double kFast = 4.0;
constexpr double kNearest = 1e-5;  // of what is orbited, in scene sizes
constexpr double kFarthest = 1e4;  // from home, in scene sizes
constexpr double kPole = 0.01;     // radians that the view keeps from straight up and down

struct Axes {
    glm::dvec3 forward;
    glm::dvec3 right;
    glm::dvec3 up;
};

Axes axesOf(const CameraPose& pose, const glm::dvec3& worldUp) {
    const glm::dvec3 forward = glm::normalize(pose.target - pose.origin);
    glm::dvec3 right = glm::cross(forward, worldUp);
    if (glm::length(right) < 1e-6) right = glm::cross(forward, pose.up);
    right = glm::normalize(right);
    return {forward, right, glm::cross(right, forward)};
}

/// `v` turned about the unit vector `axis` by Rodrigues' formula.
glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
    const double c = std::cos(angle);
    return c * v + std::sin(angle) * glm::cross(axis, v) + (1.0 - c) * glm::dot(axis, v) * axis;
}

/// A unit direction turned to the right and downwards, not over the poles.
glm::dvec3 turned(const glm::dvec3& direction, const glm::dvec3& right, const glm::dvec3& worldUp,
                  const glm::dvec2& radians) {
    const double fromUp = std::acos(std::clamp(glm::dot(direction, worldUp), -1.0, 1.0));
    const double wanted = std::clamp(fromUp + radians.y, kPole, glm::pi<double>() - kPole);
    return glm::normalize(rotated(rotated(direction, right, fromUp - wanted), worldUp, -radians.x));
}

}  // namespace

bool CameraInput::isIdle() const {
    return move == glm::dvec3(0.0) && turn == glm::dvec2(0.0) && pan == glm::dvec2(0.0) && wheel == 0.0;
}

void CameraMotion::reset(const CameraPose& pose, double sceneSize) {
    look(pose);
    sceneSize_ = sceneSize;
    speed_ = 0.25 * sceneSize;
}

void CameraMotion::look(const CameraPose& pose) {
    pose_ = pose;
    home_ = pose.origin;
    worldUp_ = glm::normalize(pose.up);
    // A camera that looks down at a scene with the usual up has that up, slightly tilted.
    for (const glm::dvec3& axis : {glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)})
        if (glm::dot(worldUp_, axis) > 0.7) worldUp_ = axis;
}

bool CameraMotion::advance(const CameraInput& input, Navigation navigation, double seconds, double height) {
    const bool flies = navigation == Navigation::Fly;
    if (flies) speed_ = std::clamp(speed_ * std::pow(kSpeedPerNotch, input.wheel), 1e-4 * sceneSize_, 1e2 * sceneSize_);
    if (input.move == glm::dvec3(0.0) && input.turn == glm::dvec2(0.0) && input.pan == glm::dvec2(0.0) &&
        (flies || input.wheel == 0.0))
        return false;
    const glm::dvec2 radians = kTurnPerHeight / height * input.turn;
    const double distance = glm::length(pose_.target - pose_.origin);
    if (flies)
        turn(radians);
    else
        orbit(radians);

    const Axes axes = axesOf(pose_, worldUp_);
    const double step = speed_ * seconds * (input.fast ? kFast : 1.0);
    const double perPixel = 2.0 * distance * std::tan(glm::radians(pose_.fovDegrees) / 2.0) / height;
    shift(step * (input.move.x * axes.right + input.move.y * worldUp_ + input.move.z * axes.forward) +
          perPixel * (-input.pan.x * axes.right + input.pan.y * axes.up));
    if (!flies) {
        const double wanted = glm::length(pose_.target - pose_.origin) * std::pow(kZoomPerNotch, input.wheel);
        const double allowed = std::clamp(wanted, kNearest * sceneSize_, kFarthest * sceneSize_);
        pose_.origin = pose_.target - allowed * axesOf(pose_, worldUp_).forward;
    }
    return true;
}

void CameraMotion::turn(const glm::dvec2& radians) {
    const Axes axes = axesOf(pose_, worldUp_);
    const double distance = glm::length(pose_.target - pose_.origin);
    pose_.target = pose_.origin + distance * turned(axes.forward, axes.right, worldUp_, radians);
    pose_.up = worldUp_;
}

void CameraMotion::orbit(const glm::dvec2& radians) {
    const Axes axes = axesOf(pose_, worldUp_);
    const double distance = glm::length(pose_.target - pose_.origin);
    pose_.origin = pose_.target - distance * turned(axes.forward, axes.right, worldUp_, radians);
    pose_.up = worldUp_;
}

// Not so far away that double precision could not tell origin and target apart.
void CameraMotion::shift(const glm::dvec3& by) {
    if (glm::length(pose_.origin + by - home_) > kFarthest * sceneSize_) return;
    pose_.origin += by;
    pose_.target += by;
}

}  // namespace manylight
