#include "apps/view_model/playable_scene.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

constexpr double kSampleRate = 24.0;  // a second: where the frame of the scene looks for what moves
constexpr double kMostSamples = 240.0;

/// `first` and moments from the start to the end.
std::vector<double> samplesOf(double first, double end) {
    std::vector<double> times{first};
    const double count = std::clamp(std::ceil(end * kSampleRate), 1.0, kMostSamples);
    for (double i = 0.0; i <= count; ++i) times.push_back(end * (i / count));
    return times;
}

}  // namespace

PlayableScene::PlayableScene(const std::filesystem::path& path, InstanceMode instances, double time)
    : still_(std::make_unique<Scene>(importScene(path, {.instances = instances, .time = time}))),
      end_(still_->animationEnd) {
    if (end_ <= 0.0) return;
    still_.reset();  // before it is read again, for its memory
    time_ = std::min(time, end_);
    moving_ = std::make_unique<AnimatedScene>(path, ImportOptions{.instances = instances}, samplesOf(time_, end_));
}

AnimatedScene::Change PlayableScene::moveTo(double time, bool keepsLights) {
    const std::vector<Light> kept = keepsLights ? scene().lights : std::vector<Light>{};
    const AnimatedScene::Change change = moving_->moveTo(time);
    if (keepsLights) scene().lights = kept;
    time_ = time;
    return change;
}

void playOn(ViewSettings& settings, double end, double seconds) {
    if (!settings.plays) return;
    settings.at += settings.speed * seconds;
    if (settings.at <= end) return;
    settings.at = settings.loops ? std::fmod(settings.at, end) : end;
    settings.plays = settings.loops;
}

}  // namespace manylight
