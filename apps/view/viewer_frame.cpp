// A frame of the viewer: both sides, how far they are apart, the window, and shaders that changed.
#include "apps/view/viewer.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

namespace manylight {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kStillAfter = 0.2;     // seconds
constexpr double kWatchPeriod = 0.5;    // seconds between looks at the shaders
constexpr double kComparePeriod = 0.3;  // seconds between comparisons

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

void Viewer::measureFps() {
    passTimes_.clear();
    presenter_.finish();  // another technique may want another picture
    try {
        fps_.step(main_.renderer());
        if (fps_.isRunning()) return;
        main_.forget();  // its renderer is as the measurement left it
        tell("the FPS table is complete");
    } catch (const Error& error) {
        stopFps();
        tell(error.what(), true);
    }
}

void Viewer::followAnimation(double seconds) {
    if (!playable_.isAnimated()) return;
    ViewSettings& view = state_.view;
    playOn(view, playable_.end(), seconds);
    view.at = std::min(view.at, playable_.end());
    if (view.plays) {
        secondsSinceMove_ = 0.0;
        holdFrames_ = 0;  // what a script waited for will not come
    }
    if (view.at == playable_.time()) return;
    presenter_.finish();
    comparison_.clear();
    try {
        const AnimatedScene::Change change = playable_.moveTo(view.at, state_.lightsChanged);
        for (Side* side : {&main_, &other_}) side->sceneMoved(*state_.scene, change);
    } catch (const Error& error) {
        view.plays = false;
        view.at = playable_.time();
        tell(error.what(), true);
    }
    if (!state_.cameraMoved)
        state_.motion.look(poseOf(state_.scene->cameras[main_.settings.camera], state_.scene->frame));
}

void Viewer::render() {
    state_.isMoving = secondsSinceMove_ < kStillAfter;
    const bool isLimited = state_.isMoving && state_.view.budget > 0.0;
    state_.quality = isLimited ? state_.budget.quality(usesVpls(main_.settings)) : FrameQuality{};
    passTimes_.clear();
    renderSide(main_, sideView());
    if (needsOther()) renderSide(other_, sideView());
}

void Viewer::renderSide(Side& side, const SideView& view) {
    try {
        if (side.isStale(view)) {
            presenter_.finish();
            comparison_.clear();
            side.update(*state_.scene, view);
        }
    } catch (const Error& error) {
        tell(error.what(), true);
    }
    side.showAsAsked();
    if (!side.exists() || side.frameCount() >= frameLimit()) return;
    const Execution execution = side.render();
    passTimes_.insert(passTimes_.end(), execution.passTimes.begin(), execution.passTimes.end());
}

void Viewer::compareSides() {
    if (state_.view.compare != Compare::Difference || state_.isMoving) return comparison_.clear();
    const glm::uvec2 frames{main_.frameCount(), other_.frameCount()};
    const bool isNew = frames != comparedFrames_ || !comparison_.report();
    if (!isNew || (comparison_.report() && script_.empty() && secondsSince(comparedAt_) < kComparePeriod)) return;
    presenter_.finish();
    try {
        comparison_.update(main_.renderer(), reference_ ? *reference_ : other_.renderer().radiance(), isDone());
    } catch (const Error& error) {
        tell(error.what(), true);
    }
    comparedFrames_ = frames;
    comparedAt_ = Clock::now();
}

void Viewer::present(double since) {
    const Clock::time_point start = Clock::now();
    const bool showsDifference = state_.view.compare == Compare::Difference && comparison_.report();
    const bool isSplit = state_.view.compare == Compare::Split && other_.exists();
    presenter_.present({.picture = showsDifference ? &comparison_.picture() : &main_.renderer().display(),
                        .other = isSplit ? &other_.renderer().display() : nullptr,
                        .divider = static_cast<float>(state_.view.divider)},
                       *ImGui::GetDrawData());
    if (passTimes_.empty()) return;
    const double milliseconds = 1e3 * (since + secondsSince(start));
    passTimes_.insert(passTimes_.end(), presenter_.passTimes().begin(), presenter_.passTimes().end());
    state_.times.add(passTimes_, milliseconds);
    if (state_.isMoving && state_.view.budget > 0.0)
        state_.budget.report(milliseconds, state_.view.budget, usesVpls(main_.settings));
}

void Viewer::reloadShaders() {
    if (!reloader_->isRunning() && (watchesToGo_ > 0 || secondsSince(watchedAt_) >= kWatchPeriod)) {
        watchedAt_ = Clock::now();
        reloader_->start();
    }
    try {
        const std::optional<std::vector<CompiledShader>> compiled = reloader_->take();
        if (!compiled) return;
        watchesToGo_ -= watchesToGo_ > 0 ? 1 : 0;
        takeShaders(*compiled);
    } catch (const Error& error) {
        watchesToGo_ = 0;
        state_.shaderProblem = error.what();
    }
}

void Viewer::takeShaders(const std::vector<CompiledShader>& compiled) {
    for (const CompiledShader& shader : compiled) {
        state_.shaderProblem = shader.problem;
        if (!shader.problem.empty()) break;
        presenter_.finish();
        device_.waitIdle();
        for (gpu::PipelineLibrary* library :
             {&presenter_.pipelines(), main_.exists() ? &main_.renderer().pipelines() : nullptr,
              other_.exists() ? &other_.renderer().pipelines() : nullptr})
            if (library != nullptr) library->replaceShader(shader.name, shader.words);
        main_.forget();
        other_.forget();
        tell(fmt::format("{} is new", shader.name));
    }
}

}  // namespace manylight
