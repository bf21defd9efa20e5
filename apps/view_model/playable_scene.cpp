#include "apps/view_model/playable_scene.h"

#include "engine/scene/emission_scale.h"
#include "engine/scene/sidecar.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

std::vector<float> emissionScales(const Scene& scene) {
    std::vector<float> scales;
    for (const Material& material : scene.materials) scales.push_back(material.emissionScale);
    return scales;
}

}  // namespace

PlayableScene::PlayableScene(const std::filesystem::path& path, InstanceMode instances, std::optional<double> time) {
    std::shared_ptr<const GltfFile> opened;
    ImportOptions options{.instances = instances, .opened = &opened};
    end_ = animationEndOf(path, options);
    if (end_ > 0.0) {
        time_ = std::min(time ? *time : savedMoment(path).value_or(0.0), end_);
        moving_ = std::make_unique<AnimatedScene>(path, options, samplesOfMotion(end_), time_);
    } else {
        options.time = 0.0;  // nothing moves, but weights of morph targets may be set
        still_ = std::make_unique<Scene>(importScene(path, options));
    }
}

AnimatedScene::Change PlayableScene::moveTo(double time, bool keepsLights) {
    const std::vector<Light> kept = keepsLights ? scene().lights : std::vector<Light>{};
    const std::vector<float> scales = emissionScales(scene());
    const AnimatedScene::Change change = moving_->moveTo(time);
    if (keepsLights) scene().lights = kept;
    if (change == AnimatedScene::Change::Everything && scales.size() == scene().materials.size())
        for (size_t i = 0; i < scales.size(); ++i) scaleEmission(scene().materials[i], scales[i]);
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
