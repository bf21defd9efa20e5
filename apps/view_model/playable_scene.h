// A scene file that is open, at one moment of its animation if it has one.
#pragma once

#include "apps/view_model/view_settings.h"
#include "engine/scene/animated_scene.h"

namespace manylight {

class PlayableScene {
  public:
    PlayableScene() = default;
    /// Reads the file, once, at `time` seconds, or at the end if that is later; none: where its sidecar says, or at the
    /// start. Throws Error as importScene() does.
    PlayableScene(const std::filesystem::path& path, InstanceMode instances, std::optional<double> time);

    /// At one address as long as it is not replaced. Its lights may be changed.
    Scene& scene() { return moving_ ? moving_->scene() : *still_; }
    bool isAnimated() const { return moving_ != nullptr; }
    double end() const { return end_; }  // seconds; 0: nothing moves
    double time() const { return time_; }
    /// Of an animated scene only. `keepsLights`: they stay where they are. Scales of emission stay in any case.
    AnimatedScene::Change moveTo(double time, bool keepsLights);

  private:
    std::unique_ptr<Scene> still_;
    std::unique_ptr<AnimatedScene> moving_;
    double end_ = 0.0;
    double time_ = 0.0;
};

/// `settings` after `seconds` of playing: beyond the end it begins again, or stops there. Untouched while paused.
void playOn(ViewSettings& settings, double end, double seconds);

}  // namespace manylight
