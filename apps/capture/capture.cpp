#include "apps/capture/capture.h"

#include "apps/capture/animation.h"
#include "apps/capture/aovs.h"
#include "apps/capture/frame_loop.h"
#include "apps/capture/outputs.h"
#include "engine/core/file.h"
#include "engine/core/finite.h"
#include "engine/scene/import.h"
#include "engine/techniques/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace manylight {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void writeGraph(Renderer& renderer, const std::string& stem) {
    const Renderer::GraphDump dump = renderer.dumpGraph();
    writeTextFile(stem + ".dot", dump.dot);
    writeTextFile(stem + ".json", dump.json.dump(2) + "\n");
}

uint64_t countNonFinite(const Image& image) {
    return static_cast<uint64_t>(
        std::count_if(image.texels.begin(), image.texels.end(), [](float value) { return !hasFiniteBits(value); }));
}

/// Renders local, global and both with the same settings otherwise; their pictures stand beside each other.
DisplayImage renderSideBySide(Renderer& renderer, const CaptureOptions& options) {
    const RenderSettings settings = renderer.settings();
    std::vector<DisplayImage> pictures;
    for (const Lighting lighting : {Lighting::Local, Lighting::Global, Lighting::Both}) {
        RenderSettings variant = settings;
        variant.lighting = lighting;
        renderer.restart(variant);
        renderFrames(renderer, options);
        pictures.push_back({renderer.settings().width, renderer.settings().height, renderer.displayRgba()});
    }
    return besideEachOther(pictures);
}

/// Where paths end, and what that costs: the share of the light that a closed scene, of this one's mean albedo
/// everywhere, would lack, and light paths that were cut off in the last frame.
Json depthLimit(const Renderer& renderer) {
    const int bounces = renderer.settings().bounceCount.value_or(0);
    const double albedo = double{renderer.gpuScene().meanAlbedo};
    return {{"bounces", bounces},
            {"mean_albedo", albedo},
            {"share_missing_in_a_furnace", std::pow(std::min(albedo, 1.0), bounces + 1)},
            {"light_paths_cut_off", renderer.status().pathsTruncated}};
}

/// What the bound on the geometry term is relative to, in the scene's own square units.
Json litArea(const Scene& scene, const Renderer& renderer) {
    if (!renderer.litArea()) return nullptr;
    return std::ldexp(*renderer.litArea(), 2 * scene.frame.exponent);
}

Json makeReport(const gpu::Device& device, const Scene& scene, const Renderer& renderer, const Frames& frames,
                double importSeconds, uint64_t nonFinite) {
    const auto orNull = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
    Json warnings = scene.warnings.toJson();
    for (const Json& warning : renderer.warnings().toJson()) warnings.push_back(warning);
    return {{"scene", scene.name},
            {"machine", describeMachine(device)},
            {"import", scene.importReport},
            {"settings", toJson(renderer.settings())},
            {"frames", renderer.frameCount()},
            {"ended_by", frames.endedBy},
            {"relative_standard_error", orNull(frames.relativeError)},
            {"non_finite_values", nonFinite},
            {"depth_limit", depthLimit(renderer)},
            {"lit_area", litArea(scene, renderer)},
            {"vpls_traced_last_frame", renderer.status().vplsTraced},
            {"vpls_shaded_last_frame", renderer.status().vplsShaded},
            {"memory", renderer.gpuScene().report()},
            {"plan", toJson(renderer.plan())},
            {"seconds",
             {{"import", importSeconds},
              {"bvh_build", renderer.startupTimes().bvhBuild},
              {"upload", renderer.startupTimes().upload},
              {"first_frame", frames.firstFrameSeconds},
              {"frames", frames.seconds}}},
            {"pass_milliseconds_all_frames", frames.passes},
            {"warnings", warnings}};
}

}  // namespace

std::optional<Json> capturePicture(gpu::Device& device, const Scene& scene, Renderer& renderer,
                                   const CaptureOptions& options, double importSeconds) {
    prepareAovs(renderer, options.aovs);
    if (options.targetError > 0.0) renderer.keepVariance(true);
    renderer.executor().dumpAfter(options.dumpPass);
    Frames frames = renderFrames(renderer, options);
    const bool isOneOfMany = !options.animate.empty();
    if (isOneOfMany && frames.endedBy == std::string("interrupt")) return std::nullopt;
    if (renderer.keepsVariance() && renderer.frameCount() > 1) frames.relativeError = renderer.relativeStandardError();
    renderer.executor().dumpAfter("");
    const Image radiance = renderer.radiance();
    const uint64_t nonFinite = countNonFinite(radiance);
    const Json report = makeReport(device, scene, renderer, frames, importSeconds, nonFinite);
    const DisplayImage display{renderer.settings().width, renderer.settings().height, renderer.displayRgba()};

    writeDumps(options, frames.dumped);
    printWarnings(renderer.warnings());
    const std::vector<ExrLayer> aovs = captureAovs(renderer, scene, options.aovs);
    writeOutputs(options.outputs, radiance, aovs, display, report);
    if (!options.report.empty()) writeTextFile(options.report, report.dump(2) + "\n");
    if (frames.endedBy == std::string("interrupt"))
        fail("interrupted: the picture has {} frame(s)", report["frames"].get<uint32_t>());
    if (nonFinite > 0) fail("{} channel values of the picture are not finite (written all the same)", nonFinite);
    return report;
}

void capture(const CaptureOptions& options) {
    if (options.scene.empty()) failUsage("no scene given: expected an OBJ, glTF, GLB or JSON file");
    if (!options.animate.empty()) return captureAnimation(options);
    checkOutputs(options);

    const auto start = Clock::now();
    const Scene scene =
        importScene(options.scene, {.instances = instanceModeFrom(options.instances), .time = options.sceneTime});
    const double importSeconds = secondsSince(start);
    printWarnings(scene.warnings);
    RenderSettings settings = resolveSettings(scene, options.settings);
    settings.jitter = options.mostFrames() > 1;

    gpu::Device device({.select = options.device});
    Renderer renderer(device, scene, settings);
    if (options.explain) fmt::print("{}", explain(renderer.plan()));
    if (!options.dumpGraph.empty()) writeGraph(renderer, options.dumpGraph);
    if (options.sideBySide) {
        writeSideBySide(options.outputs, renderSideBySide(renderer, options));
        printWarnings(renderer.warnings());
        return;
    }

    capturePicture(device, scene, renderer, options, importSeconds);
}

}  // namespace manylight
