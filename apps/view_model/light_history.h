// What lights were before they were changed, to take changes back.
#pragma once

#include "engine/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace manylight {

/// Everything about a scene's lights that the viewer changes.
struct LightState {
    std::vector<Light> lights;
    std::vector<float> emissionScales;  // of the materials
    bool lightsChanged = false;         // they are not those of the file any more
};

class LightHistory {
  public:
    static constexpr size_t kMostSteps = 100;

    /// Before a change of `subject`. While it is held, by the mouse, all changes of one subject are one step.
    void note(LightState before, const std::string& subject, bool isHeld);
    /// The mouse was let go.
    void letGo() { heldSubject_.clear(); }
    /// What was before the last step, which is forgotten; empty if there is none.
    std::optional<LightState> takeBack();
    size_t steps() const { return steps_.size(); }
    void clear();

  private:
    std::vector<LightState> steps_;
    std::string heldSubject_;
};

}  // namespace manylight
