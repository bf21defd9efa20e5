#include "apps/bench/error_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

std::string withError(const Estimate& value) {
    return fmt::format("{:.3e} +-{:>5.1f} %", value.mean,
                       value.mean != 0.0 ? 100.0 * value.error / std::abs(value.mean) : 0.0);
}

std::string header(const ErrorOptions& options, const ErrorRun& run, double referenceError) {
    const RenderSettings& settings = run.settings;
    std::string text =
        fmt::format("Error against run time: {}, {} triangles, {}x{} pixels, {} bounces at most\n", run.sceneName,
                    run.triangleCount, settings.width, settings.height, settings.bounceCount.value_or(-1));
    text += fmt::format("  device     {}, {} host threads, Manylight {}\n", run.machine["device"].get<std::string>(),
                        run.machine["host_threads"].get<int>(), run.machine["manylight"].get<std::string>());
    text += fmt::format("  measured   {} seeds a mode, {} s each; +- is the standard error over seeds\n",
                        run.modes.front().checkpoints.front().images.size(), options.secondsPerRun);
    const Reference& reference = run.reference;
    if (reference.halves)
        text += fmt::format(
            "  reference  path traced, {} samples a pixel, own RMSE {:.2e}; rows below 3 times that (*) say "
            "more of it than of the mode\n",
            reference.samplesPerPixel, referenceError);
    else
        text += fmt::format("  reference  {}, own error not known\n", reference.file.string());
    if (run.mask)
        text += fmt::format("  left out   {} pixels that see a lamp, or are next to one that does\n",
                            std::count(run.mask->uses.begin(), run.mask->uses.end(), 0));
    text += fmt::format("  one-off    import {:.3f} s, BVH {:.3f} s, upload {:.3f} s\n", run.importSeconds,
                        run.bvhSeconds, run.uploadSeconds);
    if (run.isInterrupted) text += "  interrupted: what was done before that\n";
    return text;
}

std::string modeTable(const ModeSummary& mode) {
    std::string text = fmt::format("\n{}: {:.1f} ms a frame (median), first frame {:.2f} s\n", mode.name,
                                   mode.frameMilliseconds, mode.warmUpSeconds);
    text += fmt::format("{:>8}{:>10}  {:<21}{:<21}{:>11}{:>9}{:>11}{:>11}\n", "frames", "seconds", "RMSE",
                        "without worst 0.1 %", "relMSE", "FLIP", "bias^2", "variance");
    for (const ErrorRow& row : mode.rows) {
        text += fmt::format("{:>8}{:>10.3f}{:<2}{:<21}{:<21}{:>11}{:>9}{:>11.2e}{:>11.2e}{}\n", row.frames, row.seconds,
                            row.isMeasurable ? "" : " *", withError(row.rmse), withError(row.rmseWithoutWorst),
                            row.relativeMse ? fmt::format("{:.2e}", row.relativeMse->mean) : "-",
                            row.flip ? fmt::format("{:.4f}", row.flip->mean) : "-", row.biasSquared, row.variance,
                            row.nonFinite > 0 ? fmt::format("  {} NON-FINITE PIXELS", row.nonFinite) : "");
    }
    const auto slope = [](const std::optional<Estimate>& value) {
        return value ? fmt::format("{:.3f} +- {:.3f}", value->mean, value->error) : "-";
    };
    text += fmt::format("  slope of log RMSE over log time: {}; without the worst 0.1 %: {}; over log frames: {}\n",
                        slope(mode.slope), slope(mode.slopeWithoutWorst), slope(mode.slopeOverFrames));
    if (mode.slopeOfMedians)
        text += fmt::format("  of the medians over seeds, over log frames: {:.3f}\n", *mode.slopeOfMedians);
    text += fmt::format("  mean radiance missing at the end: {:.3e} +- {:.1e}", mode.missing.mean, mode.missing.error);
    if (mode.cutOff)
        text += fmt::format("; cut off by the bound: {:.3e} +- {:.1e}", mode.cutOff->mean, mode.cutOff->error);
    return text + "\n";
}

std::string comparisonTable(const ErrorSummary& summary, const std::vector<Comparison>& rows, const char* title,
                            const char* unit) {
    std::string text = fmt::format("\n{}\n{:>12}", title, unit);
    for (const ModeSummary& mode : summary.modes) text += fmt::format("  {:>24}", mode.name);
    text += "\n";
    if (rows.empty()) return text + "  (no stretch that all modes have in common)\n";
    for (const Comparison& row : rows) {
        text += fmt::format("{:>12.4g}", row.at);
        const std::optional<double>& last = row.values.back();
        for (const std::optional<double>& value : row.values)
            text += fmt::format("  {:>24}", !value ? "-"
                                            : last.value_or(0.0) > 0.0
                                                ? fmt::format("{:.4g} ({:.2f} x)", *value, *value / *last)
                                                : fmt::format("{:.4g}", *value));
        text += "\n";
    }
    return text;
}

}  // namespace

std::string errorTable(const ErrorOptions& options, const ErrorRun& run, const ErrorSummary& summary) {
    std::string text = header(options, run, summary.referenceError);
    for (const ModeSummary& mode : summary.modes) text += modeTable(mode);
    text +=
        comparisonTable(summary, summary.equalTime, "RMSE at equal time (and over that of the last mode)", "seconds");
    text +=
        comparisonTable(summary, summary.equalError, "Seconds to equal RMSE (and over those of the last mode)", "RMSE");
    return text;
}

}  // namespace manylight
