#include "apps/bench/error_summary.h"

#include "engine/core/progress.h"
#include "engine/metrics/error.h"
#include "engine/metrics/error_split.h"
#include "engine/metrics/flip.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <numeric>

namespace manylight {
namespace {

constexpr double kMeasurable = 3.0;  // times the reference's own error

double meanOf(const Image& image) {
    return std::accumulate(image.texels.begin(), image.texels.end(), 0.0) / static_cast<double>(image.texels.size());
}

/// What one seed's picture says.
struct PictureError {
    ErrorReport report;
    std::optional<double> flip;
};

/// The reference, prepared.
struct Truth {
    const Reference& reference;
    const Mask* mask;                      // null: every pixel
    std::optional<HdrFlipReference> flip;  // if FLIP is asked for
    double error = 0.0;                    // RMSE of the reference, 0 if it is not known
};

PictureError measurePicture(const Image& image, const Truth& truth) {
    PictureError error{compareImages(image, truth.reference.image, truth.mask), std::nullopt};
    if (truth.flip)
        if (const auto flip = truth.flip->compare(image)) error.flip = flip->mean;
    return error;
}

/// Side by side: FLIP takes long.
std::vector<PictureError> measurePictures(const std::vector<Image>& images, const Truth& truth) {
    std::vector<std::future<PictureError>> tasks;
    for (const Image& image : images)
        tasks.push_back(std::async(std::launch::async, measurePicture, std::cref(image), std::cref(truth)));
    std::vector<PictureError> errors;
    for (auto& task : tasks) errors.push_back(task.get());
    return errors;
}

ErrorRow makeRow(const Checkpoint& checkpoint, const Truth& truth) {
    std::vector<double> rmse, withoutWorst, relativeMse, flip;
    ErrorRow row;
    for (const PictureError& error : measurePictures(checkpoint.images, truth)) {
        rmse.push_back(error.report.rmse);
        withoutWorst.push_back(error.report.rmseWithoutWorst);
        if (error.report.relativeMse) relativeMse.push_back(*error.report.relativeMse);
        if (error.flip) flip.push_back(*error.flip);
        row.nonFinite += error.report.nonFinite;
    }
    row.frames = checkpoint.frames;
    row.seconds = median(checkpoint.seconds);
    row.rmse = estimate(rmse);
    row.medianRmse = median(rmse);
    row.rmseWithoutWorst = estimate(withoutWorst);
    if (relativeMse.size() == rmse.size()) row.relativeMse = estimate(relativeMse);
    if (flip.size() == rmse.size()) row.flip = estimate(flip);
    const ErrorSplit split = splitError(checkpoint.images, truth.reference.image, truth.mask);
    row.biasSquared = split.biasSquared;
    row.variance = split.variance;
    row.isMeasurable = row.rmse.mean > kMeasurable * truth.error;
    return row;
}

double secondsOf(const ErrorRow& row) { return row.seconds; }
double framesOf(const ErrorRow& row) { return static_cast<double>(row.frames); }

/// RMSE against the truth: the squared error against a reference has that of the reference in it, which is independent.
double rmseOf(const ErrorReport& report, const Truth& truth) {
    return std::sqrt(std::max(report.rmse * report.rmse - truth.error * truth.error, 0.0));
}

double rmseWithoutWorstOf(const ErrorReport& report, const Truth&) { return report.rmseWithoutWorst; }

/// Over the logarithm of `place`. One fit a seed, so that their scatter is the slope's error.
std::optional<Estimate> slopeOf(const ModeRun& run, const std::vector<ErrorRow>& rows, const Truth& truth,
                                double (*error)(const ErrorReport&, const Truth&), double (*place)(const ErrorRow&)) {
    std::vector<double> slopes;
    for (size_t seed = 0; seed < run.checkpoints.front().images.size(); ++seed) {
        std::vector<double> places, errors;
        for (size_t i = 0; i < rows.size(); ++i) {
            if (!rows[i].isMeasurable) continue;
            const double value =
                error(compareImages(run.checkpoints[i].images[seed], truth.reference.image, truth.mask), truth);
            if (!(value > 0.0)) continue;
            places.push_back(std::log(place(rows[i])));
            errors.push_back(std::log(value));
        }
        if (places.size() < 3) return std::nullopt;
        if (const auto line = fitLine(places, errors)) slopes.push_back(line->slope);
    }
    if (slopes.size() < 2) return std::nullopt;
    return estimate(slopes);
}

/// The median of many draws without a variance falls as fast as most of them do.
std::optional<double> slopeOfMedians(const std::vector<ErrorRow>& rows) {
    std::vector<double> places, errors;
    for (const ErrorRow& row : rows) {
        if (!row.isMeasurable || !(row.medianRmse > 0.0)) continue;
        places.push_back(std::log(framesOf(row)));
        errors.push_back(std::log(row.medianRmse));
    }
    const auto line = places.size() < 3 ? std::nullopt : fitLine(places, errors);
    return line ? std::optional(line->slope) : std::nullopt;
}

ModeSummary summariseMode(const ModeRun& run, const Truth& truth, Progress& progress) {
    const Image& reference = truth.reference.image;
    ModeSummary summary;
    summary.name = run.mode.name;
    summary.frameMilliseconds = run.frameSeconds.empty() ? 0.0 : 1000.0 * median(run.frameSeconds);
    summary.warmUpSeconds = run.warmUpSeconds;
    for (const Checkpoint& checkpoint : run.checkpoints) {
        summary.rows.push_back(makeRow(checkpoint, truth));
        progress.advance();
    }
    summary.slope = slopeOf(run, summary.rows, truth, rmseOf, secondsOf);
    summary.slopeWithoutWorst = slopeOf(run, summary.rows, truth, rmseWithoutWorstOf, secondsOf);
    summary.slopeOverFrames = slopeOf(run, summary.rows, truth, rmseOf, framesOf);
    summary.slopeOfMedians = slopeOfMedians(summary.rows);
    std::vector<double> missing;
    for (const Image& image : run.checkpoints.back().images) missing.push_back(meanOf(reference) - meanOf(image));
    summary.missing = estimate(missing);
    if (run.cutOff.size() > 1) summary.cutOff = estimate(run.cutOff);
    return summary;
}

/// y at x on the polyline through log-log points with falling or rising xs; empty outside.
std::optional<double> interpolate(const std::vector<std::pair<double, double>>& points, double x) {
    for (size_t i = 0; i + 1 < points.size(); ++i) {
        const auto [x0, y0] = points[i];
        const auto [x1, y1] = points[i + 1];
        if (x < std::min(x0, x1) || x > std::max(x0, x1) || x0 == x1) continue;
        const double t = std::log(x / x0) / std::log(x1 / x0);
        return std::exp(std::log(y0) + t * std::log(y1 / y0));
    }
    return std::nullopt;
}

std::vector<std::pair<double, double>> pointsOf(const ModeSummary& mode, bool timeFirst) {
    std::vector<std::pair<double, double>> points;
    for (const ErrorRow& row : mode.rows) {
        if (!row.isMeasurable || !(row.rmse.mean > 0.0)) continue;
        points.push_back(timeFirst ? std::pair(row.seconds, row.rmse.mean) : std::pair(row.rmse.mean, row.seconds));
    }
    return points;
}

Comparison compareAt(const std::vector<ModeSummary>& modes, double at, bool timeFirst) {
    Comparison comparison{at, {}};
    for (const ModeSummary& mode : modes) comparison.values.push_back(interpolate(pointsOf(mode, timeFirst), at));
    return comparison;
}

/// Where every mode has been measured, if there is such a stretch: its two ends and the middle between them.
std::vector<double> commonPlaces(const std::vector<ModeSummary>& modes, bool timeFirst) {
    double low = 0.0;
    double high = std::numeric_limits<double>::infinity();
    for (const ModeSummary& mode : modes) {
        const auto points = pointsOf(mode, timeFirst);
        if (points.empty()) return {};
        const auto [first, last] = std::minmax_element(points.begin(), points.end());
        low = std::max(low, first->first);
        high = std::min(high, last->first);
    }
    if (!(low < high)) return {};
    // A hair inside: rounding must not put an end beyond itself.
    return {low * (1.0 + 1e-9), std::sqrt(low * high), high * (1.0 - 1e-9)};
}

}  // namespace

ErrorSummary summarise(const ErrorRun& run, const ErrorOptions& options) {
    size_t checkpoints = 0;
    for (const ModeRun& mode : run.modes) checkpoints += mode.checkpoints.size();
    Truth truth{run.reference, run.mask ? &*run.mask : nullptr, std::nullopt, 0.0};
    if (options.flip) truth.flip.emplace(run.reference.image, FlipOptions{.mask = truth.mask});
    if (const auto& halves = run.reference.halves)
        truth.error = 0.5 * compareImages((*halves)[0], (*halves)[1], truth.mask).rmse;
    Progress progress("comparing", checkpoints);
    ErrorSummary summary;
    summary.referenceError = truth.error;
    for (const ModeRun& mode : run.modes) summary.modes.push_back(summariseMode(mode, truth, progress));
    for (const double seconds : commonPlaces(summary.modes, true))
        summary.equalTime.push_back(compareAt(summary.modes, seconds, true));
    for (const double rmse : commonPlaces(summary.modes, false))
        summary.equalError.push_back(compareAt(summary.modes, rmse, false));
    return summary;
}

}  // namespace manylight
