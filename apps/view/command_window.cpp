// Commands that do to the window what a user does, and measure what comes of it.
#include "apps/view/viewer.h"

#include <imgui.h>

namespace manylight {
namespace {

constexpr uint32_t kLatencyInputs = 20;
constexpr double kLatencyTurn = 2.0;  // pixels of the mouse

bool sameView(const Camera& a, const Camera& b) { return a.origin == b.origin && a.forward == b.forward; }

}  // namespace

bool Viewer::performWindowCommand(const Command& command) {
    const std::string& name = command.name();
    if (name == "resize") {
        window_.resize({command.whole(1, 1, 1 << 14), command.whole(2, 1, 1 << 14)});
    } else if (name == "iconify") {
        window_.minimise();
    } else if (name == "restore") {
        window_.restore();
    } else if (name == "drop") {
        window_.drop({command.words.begin() + 1, command.words.end()});
        waitFrames_ = 1;
    } else if (name == "click") {
        input_.pretendClick({command.number(1), command.number(2)});
    } else if (name == "latency") {
        startLatency(command);
    } else {
        return false;
    }
    return true;
}

void Viewer::startLatency(const Command& command) {
    if (!main_.exists() || window_.isMinimised()) fail("{}: latency: there is no picture to wait for", command.place);
    stopFps();
    holdFrames_ = 0;
    motionBefore_ = state_.motion;
    cameraMovedBefore_ = state_.cameraMoved;
    state_.latency.start(command.words.size() > 1 ? command.whole(1, 1, 1000) : kLatencyInputs);
}

void Viewer::followLatency() {
    LatencyProbe& latency = state_.latency;
    if (!latency.isRunning()) return;
    if (!main_.exists()) return latency.stop();
    presenter_.finish();  // until then the frame is not there to be shown
    const std::chrono::duration<double> now = std::chrono::steady_clock::now() - start_;
    latency.presented(now.count(), !sameView(main_.renderer().camera(), cameraBefore_));
    const bool isLost = latency.isLost();
    if (isLost) latency.stop();
    if (latency.isRunning()) return;
    state_.motion = motionBefore_;
    state_.cameraMoved = cameraMovedBefore_;
    if (isLost)
        tell("latency: the picture does not follow the mouse", true);
    else
        tell(fmt::format("latency: {:.2f} frames, {:.1f} ms (median of {}, at most {:.2f} frames)",
                         latency.medianFrames(), 1e3 * latency.medianSeconds(), latency.samples().size(),
                         latency.mostFrames()));
}

void Viewer::takeLatencyInput() {
    const std::chrono::duration<double> now = std::chrono::steady_clock::now() - start_;
    if (!state_.latency.takeInput(now.count())) return;
    cameraBefore_ = main_.renderer().camera();
    const bool isOdd = state_.latency.samples().size() % 2 != 0;
    input_.pretendDrag(false, {isOdd ? -kLatencyTurn : kLatencyTurn, 0.0}, 1);
}

}  // namespace manylight
