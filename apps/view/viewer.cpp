#include "apps/view/viewer.h"

#include "apps/view/panels.h"
#include "apps/view_model/key_bindings.h"
#include "engine/core/file.h"
#include "engine/image/image_io.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace manylight {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kScriptedFrame = 1.0 / 30.0;  // seconds, whatever the clock says
constexpr double kIdlePoll = 0.05;             // seconds between frames that show nothing new
constexpr double kMessageSeconds = 6.0;
constexpr double kNumbersPeriod = 0.25;  // seconds between new numbers in the panels

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double diagonalOf(const Scene& scene) {
    return std::ldexp(glm::length(glm::dvec3(scene.boundsMax - scene.boundsMin)), scene.frame.exponent);
}

/// What the viewer asks for where nobody else asks.
RenderSettings ownSettings() {
    RenderSettings settings;
    settings.temporal = true;
    return settings;
}

/// The other side begins as what is true.
RenderSettings truthFor(RenderSettings settings) {
    settings.technique = Technique::PathTracer;
    settings.show = Show::Picture;
    settings.castShadows = true;
    return settings;
}

}  // namespace

Viewer::Start Viewer::load(const ViewerOptions& options) {
    if (options.scene.empty()) failUsage("no scene given: expected an OBJ, glTF, GLB or JSON file");
    ViewSettings view;
    for (const auto& [option, value] : options.viewSettings) applyViewSetting(view, option, value);
    const bool isTimeGiven =
        std::ranges::find(options.viewSettings, "at", &TypedSettings::value_type::first) != options.viewSettings.end();
    const std::optional<double> time = isTimeGiven ? std::optional(view.at) : std::nullopt;
    Start start{PlayableScene(options.scene, instanceModeFrom(options.instances), time), {}, {}};
    const Scene& scene = start.scene.scene();
    printWarnings(scene.warnings);
    start.settings = resolveSettings(scene, options.settings, ownSettings());
    const size_t camera = std::min<size_t>(start.settings.camera, scene.cameras.size() - 1);
    start.size = start.settings.width > 0 ? glm::uvec2(start.settings.width, start.settings.height)
                                          : scene.cameras[camera].resolution.value_or(glm::uvec2{512, 384});
    return start;
}

Viewer::Viewer(const ViewerOptions& options, Start start)
    : options_(options),
      window_("Manylight", start.size),
      device_({.select = options.device, .window = window_.system()}),
      input_(window_),
      presenter_(device_, window_, options.presentMode),
      main_(device_),
      other_(device_),
      comparison_(device_),
      lastFrame_(Clock::now()),
      start_(lastFrame_) {
    for (const auto& [option, value] : options.viewSettings) applyViewSetting(state_.view, option, value);
    if (!options.script.empty()) script_ = parseScript(readTextFile(options.script), options.script.string());
    if (!options.reference.empty()) reference_ = readExr(options.reference);
    if (!options.watchShaders.empty())
        reloader_ = std::make_unique<ShaderReloader>(options.watchShaders, device_.canTraceRays());
    main_.settings = start.settings;
    followScreen();
    main_.update(start.scene.scene(), sideView());
    take(std::move(start.scene));
}

Viewer::~Viewer() { vkDeviceWaitIdle(device_.handle()); }

void Viewer::open(const std::filesystem::path& file) {
    PlayableScene opened(file, instanceModeFrom(options_.instances), std::nullopt);
    const Scene& scene = opened.scene();
    printWarnings(scene.warnings);
    Side side(device_);
    side.settings = resolveSettings(scene, options_.settings, ownSettings());
    SideView view = sideView();
    view.camera.reset();
    side.update(scene, view);  // until here an Error leaves everything as it was
    presenter_.finish();
    main_ = std::move(side);
    take(std::move(opened));
    tell(fmt::format("opened {}", file.string()));
}

void Viewer::take(PlayableScene scene) {
    other_.drop();  // it knows the old scene
    fps_ = {};
    state_.latency.stop();
    state_.lightHistory.clear();
    playable_ = std::move(scene);
    state_.scene = &playable_.scene();
    state_.animationEnd = playable_.end();
    state_.view.at = playable_.time();
    state_.view.plays = state_.view.plays && playable_.isAnimated();
    state_.lightsChanged = false;
    state_.cameraMoved = false;
    state_.times.clear();
    state_.motion.reset(poseOf(state_.scene->cameras[main_.settings.camera], state_.scene->frame),
                        diagonalOf(*state_.scene));
    other_.settings = truthFor(main_.settings);
    comparison_.clear();
    window_.setTitle(fmt::format("{} - Manylight", state_.scene->name));
}

SideView Viewer::sideView() const {
    SideView view;
    const glm::dvec2 size = state_.view.pixelScale * glm::dvec2(windowSize_);
    view.size = glm::uvec2(glm::round(size));
    if (state_.cameraMoved) view.camera = cameraOf(state_.motion.pose(), state_.scene->frame);
    view.quality = state_.quality;
    view.isMoving = state_.isMoving;
    return view;
}

void Viewer::run() {
    while (!window_.shouldClose()) frame();
}

void Viewer::frame() {
    const bool isScripted = nextLine_ < script_.size();
    const bool rests = window_.isMinimised() || (isDone() && !isScripted);
    window_.poll(rests ? kIdlePoll : 0.0);
    const double measured = std::min(secondsSince(std::exchange(lastFrame_, Clock::now())), 0.1);
    const double seconds = script_.empty() ? measured : kScriptedFrame;
    for (const std::filesystem::path& file : window_.takeDroppedFiles())
        perform({{"open", file.string()}, "dropped file"});
    followScript();
    followScreen();
    if (reloader_) reloadShaders();

    state_.messageSeconds -= seconds;
    refreshNumbers(seconds);
    for (const std::string& command : showPanels(seconds)) perform(parseCommand(command, "panel"));
    const Clock::time_point start = Clock::now();
    if (!window_.isMinimised()) {
        if (fps_.isRunning()) {
            measureFps();
        } else {
            followAnimation(seconds);
            render();
            if (main_.exists()) compareSides();
        }
        if (main_.exists()) present(secondsSince(start));
        followLatency();
    }
    input_.endFrame();
    ++frames_;
}

void Viewer::refreshNumbers(double seconds) {
    secondsSinceNumbers_ += seconds;
    const bool isDue = secondsSinceNumbers_ >= kNumbersPeriod || state_.shown.frames == 0;
    if (!isDue || !main_.exists()) return;
    secondsSinceNumbers_ = 0.0;
    const RenderSettings& settings = main_.renderer().settings();
    state_.shown = {.times = state_.times,
                    .panelCpu = state_.panelCpu.mean(),
                    .panelGpu = presenter_.panelMilliseconds().mean(),
                    .frames = main_.frameCount(),
                    .size = {settings.width, settings.height},
                    .vplCount = settings.vplCount,
                    .isMoving = state_.isMoving,
                    .quality = state_.quality,
                    .pose = state_.motion.pose(),
                    .speed = state_.motion.speed()};
}

void Viewer::followScreen() {
    windowSize_ = window_.isMinimised() ? windowSize_ : window_.framebufferSize();
    const double wanted = state_.view.panelScale;
    isRescaled_ = input_.scalePanels(wanted > 0.0 ? static_cast<float>(wanted) : window_.contentScale());
    if (isRescaled_) presenter_.renewAtlas();
}

bool Viewer::needsOther() const {
    return state_.view.compare == Compare::Split || (state_.view.compare == Compare::Difference && !reference_);
}

bool Viewer::isDone() const {
    const auto sideIsDone = [&](const Side& side) {
        return !side.isStale(sideView()) && side.frameCount() >= frameLimit();
    };
    return !state_.isMoving && !fps_.isRunning() && !state_.latency.isRunning() && sideIsDone(main_) &&
           (!needsOther() || sideIsDone(other_));
}

bool Viewer::isWaiting() const {
    return waitFrames_ > 0 || fps_.isRunning() || state_.latency.isRunning() || input_.isClicking() ||
           watchesToGo_ > 0 || (holdFrames_ > 0 && !isDone()) ||
           (!awaited_.empty() && !std::filesystem::exists(awaited_));
}

void Viewer::followScript() {
    if (waitFrames_ > 0) --waitFrames_;
    if (nextLine_ >= script_.size() || isWaiting()) return;
    awaited_.clear();
    perform(script_[nextLine_++]);
}

void Viewer::takeInput(double seconds) {
    for (const std::string& key : input_.takePressedKeys())
        if (const std::string command = commandOfKey(key); !command.empty())
            perform(parseCommand(command, "key " + key));
    if (state_.view.compare == Compare::Split)
        if (const auto divider = input_.draggedDivider(static_cast<float>(state_.view.divider)))
            state_.view.divider = double{*divider};
    CameraInput camera = input_.camera();
    if (heldLight_) camera.turn = glm::dvec2(0.0);
    const double height = std::max(double{ImGui::GetIO().DisplaySize.y}, 1.0);
    secondsSinceMove_ += seconds;
    if (state_.motion.advance(camera, state_.view.navigation, seconds, height)) {
        state_.cameraMoved = true;
        secondsSinceMove_ = 0.0;
    }
}

std::vector<std::string> Viewer::showPanels(double seconds) {
    Clock::time_point start = Clock::now();
    input_.beginFrame(script_.empty() ? 0.0 : kScriptedFrame);
    double spent = secondsSince(start);
    takeLatencyInput();
    takeInput(seconds);
    start = Clock::now();
    PanelAnswer answer;
    if (main_.exists())
        answer = drawPanels({state_, main_, other_, comparison_, fps_, device_, presenter_.swapchain().describe(),
                             reference_.has_value(), isRescaled_, heldLight_});
    ImGui::Render();
    spent += secondsSince(start);
    state_.panelCpu.add(1e3 * spent + presenter_.uploadMilliseconds());
    if (answer.isDragging) secondsSinceMove_ = 0.0;
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) state_.lightHistory.letGo();
    return answer.commands;
}

void Viewer::tell(std::string message, bool isError) {
    if (isError && (message != state_.message || !state_.isError)) fmt::print(stderr, "manylight-view: {}\n", message);
    state_.message = std::move(message);
    state_.isError = isError;
    state_.messageSeconds = kMessageSeconds;
}

}  // namespace manylight
