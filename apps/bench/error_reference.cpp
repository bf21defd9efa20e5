#include "apps/bench/error_reference.h"

#include "apps/bench/scene_key.h"
#include "apps/common/interrupt.h"
#include "engine/core/cache_folder.h"
#include "engine/core/file.h"
#include "engine/core/progress.h"
#include "engine/image/image_io.h"
#include "engine/metrics/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace manylight {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr uint64_t kFirstSamples = 16;        // of each half, in the first round
constexpr uint32_t kFirstSeed = 0x7e000000u;  // far from those that are measured

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Two independent estimates with `samples` a pixel each, after `rounds` rounds.
struct Halves {
    Image first;
    Image second;
    uint64_t samples = 0;
    uint32_t rounds = 0;

    Image mean() const {
        Image image = first;
        for (size_t i = 0; i < image.texels.size(); ++i) image.texels[i] = 0.5f * (first.texels[i] + second.texels[i]);
        return image;
    }
    double rmse() const { return 0.5 * compareImages(first, second).rmse; }
    double relativeError() const {
        const double luminance = compareImages(first, second).meanLuminanceReference;
        return luminance > 0.0 ? rmse() / luminance : 0.0;
    }
};

void mix(Image& image, uint64_t samples, const Image& more, uint64_t moreSamples) {
    if (samples == 0) {
        image = more;
        return;
    }
    const double share = static_cast<double>(moreSamples) / static_cast<double>(samples + moreSamples);
    for (size_t i = 0; i < image.texels.size(); ++i)
        image.texels[i] += static_cast<float>(share * (double{more.texels[i]} - double{image.texels[i]}));
}

std::optional<fs::path> cacheFile(const Scene& scene, const RenderSettings& settings) {
    const std::optional<fs::path> folder = cacheFolder();
    if (!folder) return std::nullopt;
    return *folder / "references" / (sceneKey(scene, settings) + ".exr");
}

/// A file that is no such reference is as good as none: it is made anew.
Halves load(const std::optional<fs::path>& file) {
    Halves halves;
    if (!file || !fs::exists(*file)) return halves;
    try {
        const auto attributes = readExrAttributes(*file);
        halves.first = readExrLayer(*file, "first", {"R", "G", "B"});
        halves.second = readExrLayer(*file, "second", {"R", "G", "B"});
        halves.rounds = static_cast<uint32_t>(std::stoul(attributes.at("manylight.rounds")));
        halves.samples = std::stoull(attributes.at("manylight.samples"));
    } catch (const std::exception&) {
        halves = {};
    }
    return halves;
}

void save(const std::optional<fs::path>& file, const Scene& scene, const Halves& halves) {
    if (!file) return;
    std::error_code ignored;
    fs::create_directories(file->parent_path(), ignored);
    const std::vector<std::string> rgb = {"R", "G", "B"};
    writeExr(*file, {{"", rgb, halves.mean()}, {"first", rgb, halves.first}, {"second", rgb, halves.second}},
             {{"manylight.scene", scene.name},
              {"manylight.rounds", std::to_string(halves.rounds)},
              {"manylight.samples", std::to_string(halves.samples)}});
}

/// Both halves, as many new samples as there are already. Returns false, with the halves as they were, if interrupted.
bool addRound(Renderer& renderer, RenderSettings settings, Halves& halves, Progress& progress) {
    const uint64_t count = std::max(halves.samples, kFirstSamples);
    Image pictures[2];
    for (uint32_t half = 0; half < 2; ++half) {
        settings.seed = kFirstSeed + 2 * halves.rounds + half;
        renderer.restart(settings);
        for (uint64_t i = 0; i < count; ++i) {
            renderer.renderFrame();
            progress.advance();
            if (isInterrupted()) return false;
        }
        pictures[half] = renderer.radiance();
    }
    mix(halves.first, halves.samples, pictures[0], count);
    mix(halves.second, halves.samples, pictures[1], count);
    halves.samples += count;
    ++halves.rounds;
    return true;
}

/// What manylight-capture or this program wrote into the file; empty for files of other origin.
std::string sceneOf(const std::string& file) {
    const auto attributes = readExrAttributes(file);
    if (const auto scene = attributes.find("manylight.scene"); scene != attributes.end()) return scene->second;
    const auto report = attributes.find("manylight.report");
    if (report == attributes.end()) return "";
    const Json json = Json::parse(report->second, nullptr, false);
    return json.is_object() && json.contains("scene") && json["scene"].is_string() ? json["scene"].get<std::string>()
                                                                                   : "";
}

Reference readReference(const Scene& scene, const RenderSettings& settings, const std::string& file) {
    Reference reference;
    reference.image = readExr(file);
    if (const std::string origin = sceneOf(file); !origin.empty() && origin != scene.name)
        fail("--reference {}: a picture of scene {}; expected scene {}", file, origin, scene.name);
    reference.file = file;
    if (reference.image.width != settings.width || reference.image.height != settings.height)
        fail("--reference {}: {}x{} pixels; expected {}x{}, the size of the pictures", file, reference.image.width,
             reference.image.height, settings.width, settings.height);
    return reference;
}

}  // namespace

Reference makeReference(Renderer& renderer, const Scene& scene, const RenderSettings& settings,
                        const ErrorOptions& options) {
    if (!options.referenceFile.empty()) return readReference(scene, settings, options.referenceFile);
    RenderSettings truth = settings;
    truth.technique = Technique::PathTracer;
    truth.interleave = 1;
    truth.shadowRays = 0;
    truth.filter = Filter::Off;
    truth.gatherStep = 1;
    truth.temporal = false;
    truth.clamp = ClampMode::Off;
    truth.castShadows = true;
    truth.russianRoulette = true;
    truth.jitter = true;

    const std::optional<fs::path> file = cacheFile(scene, settings);
    Halves halves = load(file);
    const auto start = Clock::now();
    double secondsOfRound = 0.0;
    // A round takes twice as long as the one before it; one that would not end in time is not begun.
    while (halves.samples == 0 ||
           (halves.relativeError() > options.referenceError &&
            secondsSince(start) + 2.0 * secondsOfRound < options.referenceSeconds && !isInterrupted())) {
        const auto startOfRound = Clock::now();
        Progress progress(fmt::format("reference, round {}", halves.rounds + 1),
                          2 * std::max(halves.samples, kFirstSamples));
        if (!addRound(renderer, truth, halves, progress)) break;
        secondsOfRound = secondsSince(startOfRound);
        save(file, scene, halves);
    }
    if (halves.samples == 0) fail("interrupted before there was a reference");
    const uint64_t samples = 2 * halves.samples;
    Image image = halves.mean();
    return {std::move(image), std::array{std::move(halves.first), std::move(halves.second)}, samples,
            secondsSince(start), file.value_or("")};
}

}  // namespace manylight
