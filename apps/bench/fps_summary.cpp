#include "apps/bench/fps_summary.h"

#include "apps/bench/seed_paper.h"

#include <algorithm>

namespace manylight {
namespace {

CellSummary summariseCell(const FpsSamples& samples) {
    CellSummary summary;
    summary.cell = samples.cell;
    summary.frameCount = samples.wall.size();
    summary.wall = spreadOf(samples.wall);
    summary.fps = 1000.0 / summary.wall.median;
    summary.host = median(samples.host);
    summary.gpu = median(samples.gpu);
    summary.vplsShaded = median(samples.vplsShaded);
    for (const PassSamples& pass : samples.passes) summary.passes.push_back({pass.pass, median(pass.milliseconds)});
    return summary;
}

void compareMethods(std::vector<CellSummary>& cells) {
    for (CellSummary& summary : cells) {
        const FpsCell& cell = summary.cell;
        for (const CellSummary& other : cells) {
            if (other.cell.castShadows != cell.castShadows || other.cell.vplCount != cell.vplCount) continue;
            if (other.cell.method == FpsMethod::Deferred)
                summary.overDeferred = summary.wall.median / other.wall.median;
            if (other.cell.method == FpsMethod::Forward) summary.forwardOver = other.wall.median / summary.wall.median;
        }
        if (cell.method != FpsMethod::Forward || cell.castShadows) continue;
        for (const SeedPaperRow& row : kSeedPaperTable)
            if (row.vplCount == cell.vplCount) summary.seedOverDeferred = row.deferredFps / row.forwardFps;
    }
}

/// The seed paper has no depth pre-pass, no interleaving and no shadows of VPLs.
std::optional<Line> seedFit(FpsMethod method, bool castShadows) {
    if (castShadows || (method != FpsMethod::Forward && method != FpsMethod::Deferred)) return std::nullopt;
    std::vector<double> vpls;
    std::vector<double> milliseconds;
    for (const SeedPaperRow& row : kSeedPaperTable) {
        vpls.push_back(row.vplCount);
        milliseconds.push_back(1000.0 / (method == FpsMethod::Forward ? row.forwardFps : row.deferredFps));
    }
    return fitLine(vpls, milliseconds);
}

std::optional<FitSummary> fit(const std::vector<CellSummary>& cells, FpsMethod method, bool castShadows,
                              double pixelCount) {
    std::vector<double> vpls;
    std::vector<double> milliseconds;
    for (const CellSummary& summary : cells) {
        if (summary.cell.method != method || summary.cell.castShadows != castShadows) continue;
        vpls.push_back(summary.vplsShaded);
        milliseconds.push_back(summary.wall.median);
    }
    const std::optional<Line> line = fitLine(vpls, milliseconds);
    if (!line) return std::nullopt;
    return FitSummary{method,
                      castShadows,
                      line->intercept,
                      line->slope,
                      line->slope * 1e6 / pixelCount,
                      seedFit(method, castShadows)};
}

}  // namespace

FpsSummary summarise(const FpsRun& run) {
    FpsSummary summary;
    for (const FpsSamples& samples : run.cells) summary.cells.push_back(summariseCell(samples));
    compareMethods(summary.cells);

    const double pixelCount = static_cast<double>(run.settings.width) * run.settings.height;
    for (const bool castShadows : {false, true})
        for (const FpsMethod method : kFpsMethods)
            if (const auto line = fit(summary.cells, method, castShadows, pixelCount)) summary.fits.push_back(*line);
    return summary;
}

}  // namespace manylight
