#include "apps/bench/fps_outputs.h"

#include "apps/bench/seed_paper.h"

#include <fmt/format.h>

namespace manylight {
namespace {

Json numberOrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json toJson(const CellSummary& row) {
    Json passes = Json::object();
    for (const PassSummary& pass : row.passes) passes[pass.pass] = pass.milliseconds;
    return {{"technique", name(row.cell.method)},
            {"shadows", row.cell.castShadows},
            {"vpls", row.cell.vplCount},
            {"vpls_shaded", row.vplsShaded},
            {"frames", row.frameCount},
            {"fps", row.fps},
            {"milliseconds", {{"median", row.wall.median}, {"p5", row.wall.p5}, {"p95", row.wall.p95}}},
            {"host_milliseconds", row.host},
            {"gpu_milliseconds", row.gpu},
            {"forward_over", numberOrNull(row.forwardOver)},
            {"over_deferred", numberOrNull(row.overDeferred)},
            {"seed_paper_over_deferred", numberOrNull(row.seedOverDeferred)},
            {"pass_milliseconds", passes}};
}

Json toJson(const FitSummary& fit) {
    return {{"technique", name(fit.method)},
            {"shadows", fit.castShadows},
            {"fixed_milliseconds", fit.fixedMilliseconds},
            {"milliseconds_per_vpl", fit.millisecondsPerVpl},
            {"nanoseconds_per_pixel_and_vpl", fit.nanosecondsPerPixelAndVpl}};
}

Json seedPaperJson() {
    Json rows = Json::array();
    for (const SeedPaperRow& row : kSeedPaperTable)
        rows.push_back({{"vpls", row.vplCount}, {"forward_fps", row.forwardFps}, {"deferred_fps", row.deferredFps}});
    return {{"key", kSeedPaper}, {"machine", kSeedPaperMachine}, {"rows", rows}};
}

/// Without the settings that the cells vary.
Json commonSettings(const RenderSettings& settings) {
    Json json = toJson(settings);
    for (const char* varied : {"technique", "vpls", "shadows", "interleave", "filter", "gather-step"}) json.erase(varied);
    return json;
}

}  // namespace

std::string fpsCsv(const FpsSummary& summary) {
    std::string text =
        "technique,shadows,vpls,vpls_shaded,frames,fps,ms_median,ms_p5,ms_p95,gpu_ms,host_ms,forward_over,over_"
        "deferred,"
        "seed_paper_over_deferred\n";
    for (const CellSummary& row : summary.cells) {
        text += fmt::format("{},{},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{},{},{}\n",
                            name(row.cell.method), row.cell.castShadows ? "on" : "off", row.cell.vplCount,
                            row.vplsShaded, row.frameCount, row.fps, row.wall.median, row.wall.p5, row.wall.p95,
                            row.gpu, row.host, row.forwardOver ? fmt::format("{:.4f}", *row.forwardOver) : "",
                            row.overDeferred ? fmt::format("{:.4f}", *row.overDeferred) : "",
                            row.seedOverDeferred ? fmt::format("{:.4f}", *row.seedOverDeferred) : "");
    }
    return text;
}

Json fpsJson(const FpsOptions& options, const FpsRun& run, const FpsSummary& summary) {
    Json cells = Json::array();
    for (const CellSummary& row : summary.cells) cells.push_back(toJson(row));
    Json fits = Json::array();
    for (const FitSummary& fit : summary.fits) fits.push_back(toJson(fit));
    return {{"benchmark", "fps"},
            {"scene", run.sceneName},
            {"triangles", run.triangleCount},
            {"width", run.settings.width},
            {"height", run.settings.height},
            {"machine", run.machine},
            {"settings", commonSettings(run.settings)},
            {"one_off_seconds",
             {{"import", run.oneOff.importing},
              {"bvh_build", run.oneOff.bvhBuild},
              {"upload", run.oneOff.upload},
              {"first_frame", run.oneOff.firstFrame}}},
            {"rounds", options.roundCount},
            {"calibration_milliseconds", run.calibration},
            {"cells", cells},
            {"fits", fits},
            {"seed_paper", seedPaperJson()}};
}

}  // namespace manylight
