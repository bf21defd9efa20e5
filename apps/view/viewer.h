// The viewer: its state, and one frame after the other.
#pragma once

#include "apps/common/command_line.h"
#include "apps/view/comparison.h"
#include "apps/view/fps_rows.h"
#include "apps/view/input.h"
#include "apps/view/presenter.h"
#include "apps/view_model/camera_motion.h"
#include "apps/view_model/latency_probe.h"
#include "apps/view_model/light_history.h"
#include "apps/view_model/playable_scene.h"
#include "apps/view_model/recent_values.h"
#include "apps/view_model/script.h"
#include "apps/view_model/shader_reloader.h"
#include "apps/view_model/time_history.h"
#include "apps/view_model/view_settings.h"

#include <chrono>
#include <filesystem>

namespace manylight {

struct ViewerOptions {
    std::filesystem::path scene;
    std::filesystem::path script;
    std::filesystem::path reference;     // EXR that differences are taken from; empty: the other side
    std::filesystem::path watchShaders;  // source tree
    std::string instances = "auto";
    std::string device;
    PresentMode presentMode = PresentMode::Fifo;
    TypedSettings settings;
    TypedSettings viewSettings;
};

/// Numbers of the frames as the panels show them: not as quickly as they change, so that they can be read, and panels
/// need not be drawn every frame.
struct ShownNumbers {
    TimeHistory times;
    double panelCpu = 0.0;  // milliseconds
    double panelGpu = 0.0;
    uint32_t frames = 0;
    glm::uvec2 size{0};
    uint32_t vplCount = 0;
    bool isMoving = false;
    FrameQuality quality;
    CameraPose pose;
    double speed = 0.0;  // of the camera
};

/// What the panels tell of; they change it by commands only.
struct ViewState {
    ViewSettings view;
    Scene* scene = nullptr;
    double animationEnd = 0.0;  // seconds; 0: nothing moves by itself
    bool lightsChanged = false;
    CameraMotion motion;
    bool cameraMoved = false;  // away from the scene's camera
    bool isMoving = false;     // the camera, or a slider that is held
    FrameBudget budget;
    FrameQuality quality;
    TimeHistory times;
    RecentValues panelCpu;  // milliseconds of a frame: building, and copying what is drawn
    ShownNumbers shown;
    LatencyProbe latency;
    LightHistory lightHistory;
    std::string message;
    double messageSeconds = 0.0;  // that it is still to be seen
    bool isError = false;
    std::string shaderProblem;  // of the last reload; empty: none
};

class Viewer {
  public:
    explicit Viewer(const ViewerOptions& options) : Viewer(options, load(options)) {}
    ~Viewer();
    /// Until the window is closed or the script says so.
    void run();

  private:
    /// What there is before the window.
    struct Start {
        PlayableScene scene;
        RenderSettings settings;
        glm::uvec2 size{0};
    };
    static Start load(const ViewerOptions& options);
    Viewer(const ViewerOptions& options, Start start);

    void open(const std::filesystem::path& file);
    void take(PlayableScene scene);
    void frame();
    void followScript();
    void takeInput(double seconds);
    void followScreen();
    void refreshNumbers(double seconds);
    void reloadShaders();
    void takeShaders(const std::vector<CompiledShader>& compiled);
    void takeLatencyInput();
    void followLatency();
    void measureFps();
    void followAnimation(double seconds);
    void render();
    void renderSide(Side& side, const SideView& view);
    void compareSides();
    std::vector<std::string> showPanels(double seconds);
    void present(double since);
    bool isDone() const;
    bool isWaiting() const;
    uint32_t frameLimit() const { return holdFrames_ > 0 ? holdFrames_ : state_.view.frameLimit; }
    bool needsOther() const;
    SideView sideView() const;

    /// Does what a command says; an Error becomes the message.
    void perform(const Command& command);
    void performCommand(const Command& command);
    bool performFileCommand(const Command& command);
    bool performLightCommand(const Command& command);
    bool performWindowCommand(const Command& command);
    void pretendInput(const Command& command);
    void set(const std::string& option, const std::string& value);
    void chooseNext(const std::string& option);
    void startFps(const Command& command);
    void stopFps();
    void changeLight(const Command& command);
    void changeEmission(const Command& command);
    void undoLights();
    LightState lightState() const;
    void relight();
    void startLatency(const Command& command);
    void tell(std::string message, bool isError = false);
    void copyView();
    void saveView(std::filesystem::path file);
    void capture(std::filesystem::path file);
    void writeReport(const std::filesystem::path& file);
    Json viewJson(const std::filesystem::path& target) const;
    std::optional<double> moment() const;
    std::filesystem::path freshName(const char* extension) const;

    ViewerOptions options_;
    Window window_;
    gpu::Device device_;
    Input input_;
    Presenter presenter_;
    PlayableScene playable_;
    ViewState state_;
    Side main_;
    Side other_;
    Comparison comparison_;
    FpsRows fps_;
    std::optional<Image> reference_;
    std::unique_ptr<ShaderReloader> reloader_;
    std::vector<Command> script_;
    size_t nextLine_ = 0;
    uint32_t waitFrames_ = 0;        // of the script
    uint32_t watchesToGo_ = 0;       // looks at the shaders that the script waits for
    std::filesystem::path awaited_;  // a file that the script waits for
    uint32_t holdFrames_ = 0;        // the script wants the mean of so many; 0: no wish
    std::chrono::steady_clock::time_point lastFrame_;
    double secondsSinceMove_ = 1e9;
    double secondsSinceNumbers_ = 1e9;
    glm::uvec2 windowSize_{1};   // in pixels, before it was minimised
    CameraMotion motionBefore_;  // the measurement of latency
    bool cameraMovedBefore_ = false;
    Camera cameraBefore_;              // the last input of it
    bool isRescaled_ = false;          // the panels are to be laid out again
    std::optional<size_t> heldLight_;  // by the mouse, which does not turn the camera then
    std::vector<PassTime> passTimes_;  // of the frame at hand
    glm::uvec2 comparedFrames_{0};     // of both sides
    std::chrono::steady_clock::time_point comparedAt_;
    std::chrono::steady_clock::time_point watchedAt_;
    std::chrono::steady_clock::time_point start_;
    uint64_t frames_ = 0;
};

}  // namespace manylight
