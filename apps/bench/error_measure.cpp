#include "apps/bench/error_measure.h"

#include "apps/common/interrupt.h"
#include "engine/core/progress.h"
#include "engine/scene/import.h"
#include "engine/techniques/gbuffer_capture.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace manylight {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double meanOf(const Image& image) {
    return std::accumulate(image.texels.begin(), image.texels.end(), 0.0) / static_cast<double>(image.texels.size());
}

/// Seconds of one frame, from the call to the fence.
double timeFrame(Renderer& renderer) {
    const auto start = Clock::now();
    renderer.renderFrame();
    return secondsSince(start);
}

/// The first frame, which may compile, and one more to see how long a frame takes.
void warmUp(Renderer& renderer, ModeRun& run, double secondsPerRun) {
    renderer.restart(run.mode.settings);
    run.warmUpSeconds = timeFrame(renderer);
    const double seconds = timeFrame(renderer);
    if (seconds > secondsPerRun)
        fail("--seconds {}: a frame of {} takes {:.1f} s; expected time for two frames at least", secondsPerRun,
             run.mode.name, seconds);
    for (uint32_t frames = 1; frames <= 2 || frames * seconds <= secondsPerRun; frames *= 2)
        run.checkpoints.push_back({frames, {}, {}});
}

/// One seed of one mode. Interrupted, it leaves nothing.
bool runSeed(Renderer& renderer, ModeRun& run, uint32_t seed, Progress& progress) {
    RenderSettings settings = run.mode.settings;
    settings.seed = seed;
    renderer.restart(settings);
    std::vector<Image> images;
    std::vector<double> seconds;
    std::vector<double> frameSeconds;
    double total = 0.0;
    while (images.size() < run.checkpoints.size()) {
        const double frame = timeFrame(renderer);
        total += frame;
        if (renderer.frameCount() > 1) frameSeconds.push_back(frame);
        if (renderer.frameCount() == run.checkpoints[images.size()].frames) {
            images.push_back(renderer.radiance());
            seconds.push_back(total);
        }
        if (isInterrupted()) return false;
    }
    for (size_t i = 0; i < images.size(); ++i) {
        run.checkpoints[i].images.push_back(std::move(images[i]));
        run.checkpoints[i].seconds.push_back(seconds[i]);
    }
    run.frameSeconds.insert(run.frameSeconds.end(), frameSeconds.begin(), frameSeconds.end());
    progress.advance();
    return true;
}

/// What the bound takes, with the same seeds. A few suffice: it is a mean over the whole picture. Its frames ask every
/// VPL, however few the mode asks: seeds for which there is no time are left out.
void measureCutOff(Renderer& renderer, ModeRun& run, uint32_t seedCount, double secondsPerRun) {
    constexpr uint32_t kMostSeeds = 4;
    const auto start = Clock::now();
    const auto hasTime = [&] { return !isInterrupted() && secondsSince(start) < 2.0 * kMostSeeds * secondsPerRun; };
    const uint32_t frames = run.checkpoints.back().frames;
    RenderSettings settings = run.mode.settings;
    renderer.restart(settings);
    renderer.keepCutOff(true);
    for (settings.seed = 0; settings.seed < std::min(seedCount, kMostSeeds) && hasTime(); ++settings.seed) {
        renderer.restart(settings);
        while (renderer.frameCount() < frames && hasTime()) renderer.renderFrame();
        if (renderer.frameCount() == frames) run.cutOff.push_back(meanOf(renderer.cutOff()));
    }
    renderer.keepCutOff(false);
}

/// Without pixels whose centre sees an emitter, and those next to them.
Mask maskOfLamps(Renderer& renderer, const Scene& scene) {
    const GBufferImage gbuffer = captureGBuffer(renderer, scene);
    const auto width = static_cast<int>(renderer.settings().width);
    const auto height = static_cast<int>(renderer.settings().height);
    Mask mask{renderer.settings().width, renderer.settings().height, {}};
    mask.uses.assign(gbuffer.texels.size(), 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const GBufferTexel& texel = gbuffer.texels[static_cast<size_t>(y * width + x)];
            if (!texel.isSurface || scene.materials[texel.material].emittedRadiance == glm::vec3(0.0f)) continue;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
                    mask.uses[static_cast<size_t>(v * width + u)] = 0;
        }
    return mask;
}

bool hasVanishingBound(const RenderSettings& settings) {
    return settings.technique == Technique::Deferred && settings.clamp == ClampMode::Bound;
}

/// Seeds outside, modes inside: a machine that slows down meanwhile slows all of them.
void runModes(Renderer& renderer, ErrorRun& run, const ErrorOptions& options) {
    for (ModeRun& mode : run.modes) warmUp(renderer, mode, options.secondsPerRun);
    Progress progress("measuring", options.seedCount * run.modes.size());
    for (uint32_t seed = 0; seed < options.seedCount && !isInterrupted(); ++seed)
        for (ModeRun& mode : run.modes)
            if (!runSeed(renderer, mode, seed, progress)) break;
    for (ModeRun& mode : run.modes)
        if (hasVanishingBound(mode.mode.settings))
            measureCutOff(renderer, mode, options.seedCount, options.secondsPerRun);
}

}  // namespace

ErrorRun measureError(const ErrorOptions& options) {
    const InterruptGuard guard;
    ErrorRun run;
    const auto start = Clock::now();
    const Scene scene = importScene(options.scene);
    run.importSeconds = secondsSince(start);
    const RenderSettings common = resolveSettings(scene, options.settings);
    const std::vector<std::string> names =
        options.modes.empty() ? std::vector<std::string>(std::begin(kDefaultModes), std::end(kDefaultModes))
                              : options.modes;
    for (const std::string& name : names) run.modes.push_back({errorModeFrom(name, common), {}, {}, 0.0, {}});

    gpu::Device device({.select = options.device});
    Renderer renderer(device, scene, run.modes.front().mode.settings);
    run.settings = renderer.settings();
    run.machine = describeMachine(device);
    run.sceneName = scene.name;
    run.triangleCount = scene.triangles.size();
    run.bvhSeconds = renderer.startupTimes().bvhBuild;
    run.uploadSeconds = renderer.startupTimes().upload;
    run.reference = makeReference(renderer, scene, run.settings, options);
    if (options.leaveOutLamps) run.mask = maskOfLamps(renderer, scene);
    if (!isInterrupted()) runModes(renderer, run, options);
    run.isInterrupted = isInterrupted();
    run.warnings = scene.warnings;
    run.warnings.merge(renderer.warnings());
    for (const ModeRun& mode : run.modes)
        if (mode.checkpoints.empty() || mode.checkpoints.front().images.size() < 2)
            fail("interrupted before two seeds of every mode were done{}",
                 run.reference.file.empty() ? "" : "; the reference is kept");
    return run;
}

}  // namespace manylight
