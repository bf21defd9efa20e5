#include "apps/view_model/light_history.h"

#include <utility>

namespace manylight {

void LightHistory::note(LightState before, const std::string& subject, bool isHeld) {
    if (isHeld && subject == heldSubject_) return;
    heldSubject_ = isHeld ? subject : std::string();
    steps_.push_back(std::move(before));
    if (steps_.size() > kMostSteps) steps_.erase(steps_.begin());
}

std::optional<LightState> LightHistory::takeBack() {
    heldSubject_.clear();
    if (steps_.empty()) return std::nullopt;
    std::optional<LightState> before = std::move(steps_.back());
    steps_.pop_back();
    return before;
}

void LightHistory::clear() {
    steps_.clear();
    heldSubject_.clear();
}

}  // namespace manylight
