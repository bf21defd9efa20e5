#include "apps/capture/animation.h"

#include "apps/capture/outputs.h"
#include "apps/common/interrupt.h"
#include "engine/core/file.h"
#include "engine/core/progress.h"
#include "engine/scene/animated_scene.h"
#include "engine/techniques/renderer.h"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cmath>

namespace manylight {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kMostPictures = 1'000'000;

double milliseconds(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A renderer that follows the scene.
class MovingRenderer {
  public:
    MovingRenderer(gpu::Device& device, AnimatedScene& scene, const RenderSettings& settings)
        : scene_(scene), settings_(settings), renderer_(device, scene.scene(), settings) {}
    Renderer& renderer() { return renderer_; }

    /// Returns what it took, for the report.
    Json moveTo(double time) {
        const auto start = Clock::now();
        const AnimatedScene::Change change = scene_.moveTo(time);
        const double reading = milliseconds(start);
        const bool isWhole = change == AnimatedScene::Change::Everything;
        isWhole ? renderer_.sceneReplaced(settings_) : renderer_.sceneMoved(settings_);
        return {{"rebuilt", isWhole ? "everything" : "upper level and emitters"},
                {"scene_milliseconds", reading},
                {"device_milliseconds", milliseconds(start) - reading}};
    }

  private:
    AnimatedScene& scene_;
    RenderSettings settings_;
    Renderer renderer_;
};

CaptureOptions optionsOfPicture(CaptureOptions options, size_t number) {
    for (std::filesystem::path& output : options.outputs) output = numbered(output, number);
    options.showsProgress = false;
    options.report.clear();
    return options;
}

}  // namespace

std::vector<double> timesOf(const std::string& range) {
    double numbers[3] = {};
    const char* at = range.data();
    const char* const end = at + range.size();
    bool isRead = true;
    for (size_t i = 0; i < 3 && isRead; ++i) {
        const auto [next, error] = std::from_chars(at, end, numbers[i]);
        isRead = error == std::errc{} && (i == 2 ? next == end : next != end && *next == ':');
        at = next + (i == 2 ? 0 : 1);
    }
    const auto [from, to, rate] = numbers;
    if (!isRead || !(from >= 0.0) || !(to >= from) || !(rate > 0.0) || !std::isfinite(to * rate))
        failUsage("--animate {}: expected FROM:TO:RATE, like 0:2:24 for 0 to 2 seconds at 24 pictures a second", range);
    const double count = std::floor((to - from) * rate * (1.0 + 1e-12) + 1e-9) + 1.0;
    if (count > double{kMostPictures}) failUsage("--animate {}: expected at most {} pictures", range, kMostPictures);
    std::vector<double> times;
    for (size_t i = 0; i < static_cast<size_t>(count); ++i) times.push_back(from + static_cast<double>(i) / rate);
    return times;
}

std::filesystem::path numbered(const std::filesystem::path& pattern, size_t number) {
    std::string name = pattern.filename().string();
    const size_t first = name.find('#');
    if (first == std::string::npos)
        failUsage("-o {}: expected # signs where the pictures' numbers go, like frame_####.png", pattern.string());
    const size_t digits = std::min(name.find_first_not_of('#', first), name.size()) - first;
    name.replace(first, digits, fmt::format("{:0{}}", number, digits));
    return pattern.parent_path() / name;
}

void captureAnimation(const CaptureOptions& options) {
    const std::vector<double> times = timesOf(options.animate);
    if (options.outputs.empty()) failUsage("--animate: expected -o, like -o frame_####.png");
    checkOutputs(optionsOfPicture(options, 0));
    if (!options.report.empty()) requireWritable(options.report);

    const InterruptGuard guard;
    AnimatedScene scene(options.scene, {.instances = instanceModeFrom(options.instances)}, times);
    printWarnings(scene.scene().warnings);
    RenderSettings settings = resolveSettings(scene.scene(), options.settings);
    settings.jitter = options.mostFrames() > 1;
    gpu::Device device({.select = options.device});
    MovingRenderer moving(device, scene, settings);
    if (options.explain) fmt::print("{}", explain(moving.renderer().plan()));

    Json pictures = Json::array();
    Progress progress("pictures", times.size());
    for (size_t i = 0; i < times.size(); ++i) {
        Json picture = i > 0 ? moving.moveTo(times[i]) : Json::object();
        const auto start = Clock::now();
        const std::optional<Json> report =
            capturePicture(device, scene.scene(), moving.renderer(), optionsOfPicture(options, i), 0.0);
        if (!report) fail("interrupted: {} of {} pictures are written", i, times.size());
        picture["time"] = times[i];
        picture["picture_milliseconds"] = milliseconds(start);
        picture["report"] = *report;
        pictures.push_back(std::move(picture));
        progress.advance();
        if (isInterrupted() && i + 1 < times.size())
            fail("interrupted: {} of {} pictures are written", i + 1, times.size());
    }
    if (!options.report.empty()) writeTextFile(options.report, Json{{"pictures", std::move(pictures)}}.dump(2) + "\n");
}

}  // namespace manylight
