#include "apps/bench/fps_table.h"

#include "apps/bench/seed_paper.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace manylight {
namespace {

/// Three digits or more, however short or long the frame.
std::string number(double value) { return fmt::format("{:.{}f}", value, value < 1.0 ? 3 : value < 100.0 ? 2 : 1); }

std::string numberOrDash(const std::optional<double>& value) { return value ? fmt::format("{:.2f}", *value) : "-"; }

bool has(const FpsSummary& summary, bool castShadows) {
    return std::any_of(summary.cells.begin(), summary.cells.end(),
                       [&](const CellSummary& cell) { return cell.cell.castShadows == castShadows; });
}

std::string header(const FpsOptions& options, const FpsRun& run) {
    const Json& machine = run.machine;
    const RenderSettings& settings = run.settings;
    std::string text = fmt::format("Frames per second: {}, {} triangles, {}x{} pixels, seed {}\n", run.sceneName,
                                   run.triangleCount, settings.width, settings.height, settings.seed);
    text += fmt::format("  device       {}{}, Vulkan {}\n               driver {}\n",
                        machine["device"].get<std::string>(), run.softwareDevice ? " (software)" : "",
                        machine["vulkan"].get<std::string>(), machine["driver"].get<std::string>());
    text += fmt::format("  host         {} threads, Manylight {}\n", machine["host_threads"].get<int>(),
                        machine["manylight"].get<std::string>());
    text += fmt::format("  measured     submit to fence, {} interleaved round(s), {} frames and {} s a row at least\n",
                        options.roundCount, options.framesPerCell, options.secondsPerCell);
    const OneOffTimes& oneOff = run.oneOff;
    text += fmt::format("  one-off      import {:.3f} s, BVH {:.3f} s, upload {:.3f} s, first frame {:.3f} s\n",
                        oneOff.importing, oneOff.bvhBuild, oneOff.upload, oneOff.firstFrame);
    const auto [low, high] = std::minmax_element(run.calibration.begin(), run.calibration.end());
    text += fmt::format(
        "  calibration  a C++ loop took {:.1f} ms before, {:.1f} ms after ({:.1f} to {:.1f} in all): "
        "the machine's own noise\n",
        run.calibration.front(), run.calibration.back(), *low, *high);
    return text;
}

std::string framesTable(const FpsSummary& summary, bool castShadows) {
    std::string text = fmt::format("\nVPLs {} shadows\n", castShadows ? "with" : "without");
    text += fmt::format("{:>6}  {:<16}{:>8}{:>11}  [{:>9} ..{:>9}]{:>12}{:>11}{:>8}{:>8}{:>8}\n", "VPLs", "technique",
                        "FPS", "median ms", "5 %", "95 %", "/ deferred", "forward /", "seed *", "frames", "shaded");
    uint32_t lastCount = ~0u;
    for (const CellSummary& row : summary.cells) {
        if (row.cell.castShadows != castShadows) continue;
        const bool isNewCount = row.cell.vplCount != lastCount;
        lastCount = row.cell.vplCount;
        text += fmt::format("{:>6}  {:<16}{:>8}{:>11}  [{:>9} ..{:>9}]{:>12}{:>11}{:>8}{:>8}{:>8.0f}\n",
                            isNewCount ? std::to_string(lastCount) : "", name(row.cell.method), number(row.fps),
                            number(row.wall.median), number(row.wall.p5), number(row.wall.p95),
                            numberOrDash(row.overDeferred), numberOrDash(row.forwardOver),
                            numberOrDash(row.seedOverDeferred), row.frameCount, row.vplsShaded);
    }
    return text;
}

std::string fitTable(const FpsSummary& summary) {
    if (summary.fits.empty()) return "";
    std::string text = "\nFit: ms of a frame = fixed + per VPL * VPLs (least squares over the medians)\n";
    text += fmt::format("  {:<16}{:<9}{:>10}{:>12}{:>22}{:>16}{:>15}\n", "technique", "shadows", "fixed ms",
                        "ms per VPL", "ns per pixel and VPL", "seed *: fixed", "ms per VPL");
    for (const FitSummary& fit : summary.fits) {
        text += fmt::format("  {:<16}{:<9}{:>10.2f}{:>12.4f}{:>22.3f}{:>16}{:>15}\n", name(fit.method),
                            fit.castShadows ? "on" : "off", fit.fixedMilliseconds, fit.millisecondsPerVpl,
                            fit.nanosecondsPerPixelAndVpl, fit.seed ? fmt::format("{:.2f}", fit.seed->intercept) : "-",
                            fit.seed ? fmt::format("{:.4f}", fit.seed->slope) : "-");
    }
    return text;
}

/// Of deferred shading if it was measured, at the largest VPL count.
std::string passTable(const FpsSummary& summary, bool castShadows) {
    const CellSummary* largest = nullptr;
    for (const CellSummary& row : summary.cells)
        if (row.cell.castShadows == castShadows && (largest == nullptr || row.cell.method == FpsMethod::Deferred))
            largest = &row;
    std::string text =
        fmt::format("\nTime per pass: {}, {} VPLs {} shadows (GPU, medians)\n", name(largest->cell.method),
                    largest->cell.vplCount, castShadows ? "with" : "without");
    text += fmt::format("  {:<40}{:>10}{:>9}\n", "pass", "ms", "share");
    for (const PassSummary& pass : largest->passes)
        text += fmt::format("  {:<40}{:>10.3f}{:>7.1f} %\n", pass.pass, pass.milliseconds,
                            100.0 * pass.milliseconds / largest->wall.median);
    text += fmt::format("  {:<40}{:>10.3f}{:>7.1f} %\n", "all passes, first to last", largest->gpu,
                        100.0 * largest->gpu / largest->wall.median);
    text += fmt::format("  {:<40}{:>10.3f}\n", "frame, submit to fence", largest->wall.median);
    text += fmt::format("  {:<40}{:>10.3f}\n", "host besides: declare, compile, record", largest->host);
    return text;
}

}  // namespace

std::string fpsTable(const FpsOptions& options, const FpsRun& run, const FpsSummary& summary) {
    std::string text = header(options, run);
    if (has(summary, true) && options.shadowedVplCounts.empty() &&
        run.shadowedVplCounts.size() < options.vplCounts.size())
        text += fmt::format(
            "  shortened    with shadows only {} VPLs: rays are slow on a software driver; "
            "--shadowed-vpls sets the list\n",
            fmt::join(run.shadowedVplCounts, ", "));
    for (const bool castShadows : {false, true})
        if (has(summary, castShadows)) text += framesTable(summary, castShadows);
    text += fitTable(summary);
    for (const bool castShadows : {false, true})
        if (has(summary, castShadows)) text += passTable(summary, castShadows);
    text += fmt::format(
        "\n* {}, {}: compare ratios and slopes, not FPS. \"/ deferred\" is the frame time over deferred's, \"forward "
        "/\" forward's over it.\n",
        kSeedPaper, kSeedPaperMachine);
    return text;
}

}  // namespace manylight
