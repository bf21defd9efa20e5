// How keys and mouse move the camera: flying, or turning about what it looks at.
#pragma once

#include "apps/view_model/camera_pose.h"

namespace manylight {

/// What is asked for in one frame.
struct CameraInput {
    glm::dvec3 move{0.0};  // right, up, forward: -1 to 1 each
    glm::dvec2 turn{0.0};  // pixels that the mouse was dragged, y down
    glm::dvec2 pan{0.0};   // the same with the other button
    double wheel = 0.0;    // notches, away from the user
    bool fast = false;

    bool isIdle() const;
};

enum class Navigation : uint8_t { Fly, Orbit };

class CameraMotion {
  public:
    /// `sceneSize`: the diagonal of the scene, in its units. Up is where the pose has it.
    void reset(const CameraPose& pose, double sceneSize);
    /// Goes to another pose; speed and size stay.
    void look(const CameraPose& pose);
    /// `seconds` since the last frame; `height` of the window in pixels. Returns whether the camera moved.
    bool advance(const CameraInput& input, Navigation navigation, double seconds, double height);

    const CameraPose& pose() const { return pose_; }
    /// Scene units a second.
    double speed() const { return speed_; }

  private:
    void turn(const glm::dvec2& radians);
    void orbit(const glm::dvec2& radians);
    void shift(const glm::dvec3& by);

    CameraPose pose_;
    glm::dvec3 home_{0.0};  // where it was told to look from
    glm::dvec3 worldUp_{0.0, 1.0, 0.0};
    double sceneSize_ = 1.0;
    double speed_ = 0.25;
};

}  // namespace manylight
