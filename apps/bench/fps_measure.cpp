#include "apps/bench/fps_measure.h"

#include "apps/bench/calibration.h"
#include "apps/common/interrupt.h"
#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/core/statistics.h"
#include "engine/scene/import.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace manylight {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

bool contains(const std::vector<std::string>& list, const std::string& text) {
    return std::find(list.begin(), list.end(), text) != list.end();
}

std::vector<uint32_t> ascending(std::vector<uint32_t> counts) {
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    return counts;
}

/// As asked for; else all of them, but on a software driver only the small ones.
std::vector<uint32_t> shadowedCounts(const FpsOptions& options, bool softwareDevice) {
    if (!options.shadowedVplCounts.empty()) return ascending(options.shadowedVplCounts);
    std::vector<uint32_t> counts = ascending(options.vplCounts);
    if (softwareDevice)
        while (counts.size() > 1 && counts.back() > kMaxShadowedOnSoftware) counts.pop_back();
    return counts;
}

std::vector<FpsSamples> makeCells(const FpsOptions& options, const std::vector<uint32_t>& shadowedVplCounts) {
    std::vector<FpsSamples> cells;
    for (const bool castShadows : {false, true}) {
        if (!contains(options.shadows, castShadows ? "on" : "off")) continue;
        for (const uint32_t vplCount : castShadows ? shadowedVplCounts : ascending(options.vplCounts))
            for (const FpsMethod method : kFpsMethods) {
                if (!contains(options.techniques, name(method))) continue;
                FpsSamples samples;
                samples.cell = {method, castShadows, vplCount};
                cells.push_back(std::move(samples));
            }
    }
    return cells;
}

double firstFrameSeconds(Renderer& renderer, const RenderSettings& settings, const std::vector<FpsSamples>& cells) {
    if (cells.empty()) return 0.0;
    restartFor(renderer, settings, cells.front().cell);
    const auto start = Clock::now();
    renderer.renderFrame();
    return secondsSince(start);
}

/// Frames that are not counted: pipelines are compiled and caches filled in them. Slow ones need no repetition.
void warmUp(Renderer& renderer, const FpsSamples& samples) {
    const bool isFirstRound = samples.wall.empty();
    if (!isFirstRound && median(samples.wall) > kSlowFrame) return;
    const int frameCount = isFirstRound ? 3 : 1;
    for (int i = 0; i < frameCount; ++i)
        if (measureFrame(renderer, nullptr) > kSlowFrame) return;
}

/// One cell's turn in a round.
void measureCell(Renderer& renderer, const RenderSettings& settings, const FpsOptions& options, FpsSamples& samples) {
    restartFor(renderer, settings, samples.cell);
    warmUp(renderer, samples);
    const double milliseconds = 1000.0 * options.secondsPerCell / options.roundCount;
    const uint32_t frames = (options.framesPerCell + options.roundCount - 1) / options.roundCount;
    double spent = 0.0;
    for (uint32_t i = 0; (i < frames || spent < milliseconds) && !isInterrupted(); ++i)
        spent += measureFrame(renderer, &samples);
}

}  // namespace

FpsRun measureFps(const FpsOptions& options) {
    const InterruptGuard guard;
    const auto start = Clock::now();
    const Scene scene = importScene(options.scene);
    const double importSeconds = secondsSince(start);
    printWarnings(scene.warnings);
    RenderSettings settings = resolveSettings(scene, options.settings);
    settings.show = Show::Picture;

    gpu::Device device({.select = options.device});
    FpsRun run;
    run.sceneName = scene.name;
    run.triangleCount = scene.triangles.size();
    run.machine = describeMachine(device);
    run.softwareDevice = device.info().isSoftware();
    run.shadowedVplCounts = shadowedCounts(options, run.softwareDevice);
    run.cells = makeCells(options, run.shadowedVplCounts);

    Renderer renderer(device, scene, settings);
    renderer.keepDisplay();
    run.settings = renderer.settings();
    run.oneOff = {importSeconds, renderer.startupTimes().bvhBuild, renderer.startupTimes().upload,
                  firstFrameSeconds(renderer, settings, run.cells)};
    Progress progress("measuring", options.roundCount * run.cells.size());
    for (uint32_t round = 0; round < options.roundCount && !isInterrupted(); ++round) {
        run.calibration.push_back(calibrationMilliseconds());
        for (FpsSamples& samples : run.cells) {
            if (isInterrupted()) break;
            measureCell(renderer, settings, options, samples);
            progress.advance();
        }
    }
    run.isInterrupted = isInterrupted();
    std::erase_if(run.cells, [](const FpsSamples& samples) { return samples.wall.empty(); });
    if (run.cells.empty() && run.isInterrupted) fail("interrupted before anything was measured");
    run.calibration.push_back(calibrationMilliseconds());
    run.settings.pathCount = settings.pathCount;
    run.warnings = renderer.warnings();
    return run;
}

}  // namespace manylight
