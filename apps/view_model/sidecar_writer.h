// The sidecar that brings a view back: scene, camera, lights, settings.
#pragma once

#include "apps/view_model/camera_pose.h"
#include "engine/techniques/settings.h"

#include <filesystem>

namespace manylight {

struct ViewToSave {
    const Scene& scene;
    std::optional<CameraPose> pose;  // empty: the camera of the settings, untouched
    glm::uvec2 resolution{0};
    const RenderSettings& settings;
    bool lightsChanged = false;
    std::optional<double> moment = std::nullopt;  // of the animation, in seconds
};

/// A light as docs/scenes.md writes it, in the scene's own units.
Json lightJson(const Light& light, const SceneFrame& frame);

/// For a file in the folder of `target`. A scene that came from a sidecar keeps what that says of other things.
/// Throws Error if that sidecar cannot be read again.
Json sidecarOf(const ViewToSave& view, const std::filesystem::path& target);

}  // namespace manylight
