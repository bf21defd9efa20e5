// Commands that read and write files.
#include "apps/view/viewer.h"

#include "apps/view_model/sidecar_writer.h"
#include "engine/core/file.h"
#include "engine/image/image_io.h"

#include <imgui.h>

#include <cctype>

namespace manylight {

bool Viewer::performFileCommand(const Command& command) {
    const std::string& name = command.name();
    const std::filesystem::path file = command.words.size() > 1 ? command.words[1] : "";
    if (name == "open") {
        open(file);
    } else if (name == "copy-view") {
        copyView();
    } else if (name == "save-view") {
        saveView(file);
    } else if (name == "capture") {
        capture(file);
    } else if (name == "screenshot") {
        const Presenter::Screenshot shot = presenter_.screenshot();
        const std::filesystem::path target = file.empty() ? freshName(".png") : file;
        writePng8(target, shot.size.x, shot.size.y, shot.rgba);
        tell(fmt::format("wrote {}", target.string()));
    } else if (name == "report") {
        writeReport(file);
    } else {
        return false;
    }
    return true;
}

std::filesystem::path Viewer::freshName(const char* extension) const {
    std::string stem = state_.scene->name.empty() ? "view" : state_.scene->name;
    for (char& c : stem)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_') c = '_';
    for (int number = 1;; ++number) {
        const std::filesystem::path name = fmt::format("{}-{:03}", stem, number);
        bool isFree = true;
        for (const char* used : {".png", ".exr", ".json"})
            isFree = isFree && !std::filesystem::exists(std::filesystem::path(name).replace_extension(used));
        if (isFree) return std::filesystem::path(name).replace_extension(extension);
    }
}

Json Viewer::viewJson(const std::filesystem::path& target) const {
    std::optional<CameraPose> pose;
    if (state_.cameraMoved) pose = state_.motion.pose();
    return sidecarOf({.scene = *state_.scene,
                      .pose = pose,
                      .resolution = windowSize_,
                      .settings = main_.settings,
                      .lightsChanged = state_.lightsChanged,
                      .moment = moment()},
                     target);
}

std::optional<double> Viewer::moment() const {
    return playable_.isAnimated() ? std::optional(playable_.time()) : std::nullopt;
}

void Viewer::copyView() {
    Json view = {{"camera", toJson(state_.motion.pose(), windowSize_)}};
    if (moment()) view["at"] = *moment();
    ImGui::SetClipboardText(view.dump(2).c_str());
    tell("copied the view as a sidecar has it");
}

void Viewer::saveView(std::filesystem::path file) {
    if (file.empty()) file = freshName(".json");
    writeTextFile(file, viewJson(file).dump(2) + "\n");
    tell(fmt::format("wrote {}", file.string()));
}

void Viewer::capture(std::filesystem::path file) {
    if (main_.frameCount() == 0) fail("capture: nothing has been rendered yet");
    if (file.empty()) {
        file = freshName(".png");
        capture(file);
        capture(std::filesystem::path(file).replace_extension(".exr"));
        saveView(std::filesystem::path(file).replace_extension(".json"));
        tell(fmt::format("wrote {}, .exr and .json", file.string()));
        return;
    }
    Renderer& renderer = main_.renderer();
    const RenderSettings& settings = renderer.settings();
    presenter_.finish();
    if (file.extension() == ".exr") {
        std::map<std::string, std::string> attributes = {{"manylight.view", viewJson(file).dump()},
                                                         {"manylight.frames", std::to_string(renderer.frameCount())}};
        const Json all = toJson(settings);
        for (const auto& [option, value] : all.items()) attributes["manylight." + option] = settingText(value);
        writeExr(file, {{"", {"R", "G", "B"}, renderer.radiance()}}, attributes);
    } else if (file.extension() == ".png") {
        writePng8(file, settings.width, settings.height, renderer.displayRgba());
    } else {
        fail("capture {}: expected a name that ends in .exr or .png", file.string());
    }
    tell(fmt::format("wrote {}", file.string()));
}

void Viewer::writeReport(const std::filesystem::path& file) {
    if (!main_.exists()) fail("report: there is no picture");
    const std::chrono::duration<double> runs = std::chrono::steady_clock::now() - start_;
    const LatencyProbe& latency = state_.latency;
    Json passes = Json::object();
    for (size_t pass = 0; pass < state_.times.passes().size(); ++pass)
        passes[state_.times.passes()[pass]] = state_.times.mean(pass);
    const RenderSettings& settings = main_.renderer().settings();
    Json report = {{"scene", state_.scene->name},
                   {"machine", describeMachine(device_)},
                   {"window", presenter_.swapchain().describe()},
                   {"settings", toJson(settings)},
                   {"frames", main_.frameCount()},
                   {"seconds", runs.count()},
                   {"frames_presented", presenter_.presentedFrames()},
                   {"minimised", window_.isMinimised()},
                   {"moving", state_.isMoving},
                   {"quality", {{"scale", state_.quality.scale}, {"vpls", state_.quality.vpls}}},
                   {"frame_milliseconds_median", state_.times.medianTotal()},
                   {"pass_milliseconds_mean", passes},
                   {"panel",
                    {{"scale", input_.panelScale()},
                     {"drawn", presenter_.drawnPanels()},
                     {"cpu_milliseconds", state_.panelCpu.mean()},
                     {"cpu_milliseconds_least", state_.panelCpu.least()},
                     {"gpu_milliseconds", presenter_.panelMilliseconds().mean()}}},
                   {"message", state_.message},
                   {"is_error", state_.isError},
                   {"shader_problem", state_.shaderProblem},
                   {"validation_messages", device_.instance().validationMessages()}};
    if (playable_.isAnimated())
        report["animation"] = {{"at", playable_.time()}, {"end", playable_.end()}, {"plays", state_.view.plays}};
    if (!latency.samples().empty())
        report["latency"] = {{"inputs", latency.samples().size()},
                             {"frames_median", latency.medianFrames()},
                             {"frames_most", latency.mostFrames()},
                             {"milliseconds_median", 1e3 * latency.medianSeconds()}};
    if (!fps_.cells().empty()) report["fps_table"] = toJson(fps_);
    if (comparison_.report()) report["rmse"] = comparison_.report()->rmse;
    if (comparison_.flip()) report["flip"] = *comparison_.flip();
    writeTextFile(file, report.dump(2) + "\n");
}

}  // namespace manylight
