// One picture of the scene, with its own settings: the main one, or the one it is compared with.
#pragma once

#include "apps/view_model/frame_budget.h"
#include "engine/scene/animated_scene.h"
#include "engine/techniques/renderer.h"

#include <memory>
#include <optional>

namespace manylight {

/// What the window asks of every side, beside its settings.
struct SideView {
    glm::uvec2 size{0};            // pixels, before quality.scale
    std::optional<Camera> camera;  // empty: that of the settings
    FrameQuality quality;
    bool isMoving = false;
};

class Side {
  public:
    explicit Side(gpu::Device& device) : device_(&device) {}

    /// As the user asked for it; may be changed at any time.
    RenderSettings settings;

    /// Takes up `settings` and `view`. Where a setting does not fit the others, `settings` becomes what it was, and the
    /// Error is thrown. Nothing that presents the picture may run.
    void update(const Scene& scene, const SideView& view);
    /// Whether update() has something to do.
    bool isStale(const SideView& view) const;
    /// Takes up exposure and tone curve, which update() leaves alone: the frames so far are kept.
    void showAsAsked();
    Execution render() { return renderer_->renderFrame(); }
    void forget() { isForgotten_ = true; }
    void relight(const Scene& scene);
    /// After AnimatedScene::moveTo(), which `change` is of. Where it throws an Error, the next update() begins anew.
    void sceneMoved(const Scene& scene, AnimatedScene::Change change);
    void drop() { renderer_.reset(); }

    bool exists() const { return renderer_ != nullptr; }
    Renderer& renderer() const { return *renderer_; }
    uint32_t frameCount() const { return renderer_ ? renderer_->frameCount() : 0; }
    bool isMoving() const { return wasMoving_; }

  private:
    RenderSettings wanted(const SideView& view) const;
    void start(const Scene& scene, const RenderSettings& wanted, const SideView& view);

    gpu::Device* device_;
    std::unique_ptr<Renderer> renderer_;
    RenderSettings asked_;    // `settings` at the last update()
    RenderSettings applied_;  // what was made of them
    std::optional<Camera> camera_;
    bool isForgotten_ = false;
    bool wasMoving_ = false;
};

/// Frames whose VPLs make a frame cheaper if there are fewer.
bool usesVpls(const RenderSettings& settings);

}  // namespace manylight
