#include "apps/view/side.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

constexpr uint32_t kFewestVpls = 16;  // while something moves

bool sameCamera(const std::optional<Camera>& a, const std::optional<Camera>& b) {
    if (!a || !b) return a.has_value() == b.has_value();
    return a->origin == b->origin && a->forward == b->forward && a->up == b->up && a->verticalFov == b->verticalFov;
}

/// Settings that need other pipelines, buffers or frames; exposure and tone curve do not.
RenderSettings withoutDisplay(RenderSettings settings) {
    settings.exposure = 0.0f;
    settings.toneCurve = ToneCurve::Linear;
    return settings;
}

uint32_t share(uint32_t count, double part, uint32_t fewest) {
    if (count <= fewest) return count;
    return std::max(static_cast<uint32_t>(std::lround(count * part)), fewest);
}

}  // namespace

bool usesVpls(const RenderSettings& settings) {
    return settings.technique != Technique::PathTracer && settings.lighting != Lighting::Local;
}

RenderSettings Side::wanted(const SideView& view) const {
    RenderSettings result = settings;
    const glm::dvec2 size = view.quality.scale * glm::dvec2(view.size);
    result.width = std::max(static_cast<uint32_t>(std::lround(size.x)), 1u);
    result.height = std::max(static_cast<uint32_t>(std::lround(size.y)), 1u);
    result.vplCount = share(settings.vplCount, view.quality.vpls, kFewestVpls);
    result.lightSampleCount = share(settings.lightSampleCount, view.quality.vpls, 1);
    if (settings.pathCount > 0) result.pathCount = share(settings.pathCount, view.quality.vpls, kFewestVpls);
    result.jitter = !view.isMoving;  // while it moves, every frame is the first
    result.temporal = settings.temporal && settings.technique == Technique::Deferred;
    return result;
}

bool Side::isStale(const SideView& view) const {
    return renderer_ == nullptr || isForgotten_ || !sameCamera(camera_, view.camera) ||
           withoutDisplay(wanted(view)) != withoutDisplay(applied_);
}

void Side::start(const Scene& scene, const RenderSettings& wanted, const SideView& view) {
    if (renderer_ && wanted.materials == applied_.materials && wanted.plan == applied_.plan &&
        wanted.planKeeps == applied_.planKeeps && wanted.rays == applied_.rays) {
        renderer_->restart(wanted);
    } else {
        renderer_.reset();  // before the new one, for its memory
        renderer_ = std::make_unique<Renderer>(*device_, scene, wanted);
        renderer_->keepDisplay();
        camera_.reset();
    }
    if (!sameCamera(camera_, view.camera)) renderer_->lookThrough(view.camera.value_or(scene.cameras[wanted.camera]));
    camera_ = view.camera;
}

void Side::update(const Scene& scene, const SideView& view) {
    if (!isStale(view)) return;
    const RenderSettings next = wanted(view);
    // What moves goes on from what was seen, and so does what comes to rest.
    const bool goesOn = view.isMoving || (wasMoving_ && sameCamera(camera_, view.camera));
    if (renderer_ && (isForgotten_ || !goesOn)) renderer_->forgetHistory();
    isForgotten_ = false;
    wasMoving_ = view.isMoving;
    try {
        start(scene, next, view);
        asked_ = settings;
        applied_ = next;
    } catch (const Error&) {
        if (settings == asked_) throw;
        settings = asked_;
        applied_ = wanted(view);
        start(scene, applied_, view);
        throw;
    }
}

void Side::showAsAsked() {
    if (renderer_) renderer_->setDisplay(settings.exposure, settings.toneCurve);
}

void Side::sceneMoved(const Scene& scene, AnimatedScene::Change change) {
    if (!renderer_) return;
    if (!wasMoving_) renderer_->forgetHistory();
    try {
        change == AnimatedScene::Change::Everything ? renderer_->sceneReplaced(applied_)
                                                    : renderer_->sceneMoved(applied_);
        if (!camera_) renderer_->lookThrough(scene.cameras.at(applied_.camera));
    } catch (const Error&) {
        drop();
        throw;
    }
}

void Side::relight(const Scene& scene) {
    if (renderer_) renderer_->relight(scene);
}

}  // namespace manylight
