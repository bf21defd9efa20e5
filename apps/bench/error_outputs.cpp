#include "apps/bench/error_outputs.h"

#include "engine/image/image_io.h"

#include <fmt/format.h>

#include <algorithm>

namespace manylight {
namespace {

Json toJson(const std::optional<Estimate>& value) {
    return value ? Json{{"mean", value->mean}, {"standard_error", value->error}} : Json();
}

Json toJson(const ErrorRow& row) {
    return {{"frames", row.frames},
            {"seconds", row.seconds},
            {"rmse", toJson(std::optional(row.rmse))},
            {"rmse_median", row.medianRmse},
            {"rmse_without_worst", toJson(std::optional(row.rmseWithoutWorst))},
            {"relative_mse", toJson(row.relativeMse)},
            {"flip", toJson(row.flip)},
            {"bias_squared", row.biasSquared},
            {"variance", row.variance},
            {"non_finite_pixels", row.nonFinite},
            {"is_measurable", row.isMeasurable}};
}

Json toJson(const ModeSummary& mode) {
    Json rows = Json::array();
    for (const ErrorRow& row : mode.rows) rows.push_back(toJson(row));
    return {{"mode", mode.name},
            {"frame_milliseconds", mode.frameMilliseconds},
            {"first_frame_seconds", mode.warmUpSeconds},
            {"slope", toJson(mode.slope)},
            {"slope_without_worst", toJson(mode.slopeWithoutWorst)},
            {"slope_over_frames", toJson(mode.slopeOverFrames)},
            {"slope_of_medians_over_frames", mode.slopeOfMedians ? Json(*mode.slopeOfMedians) : Json()},
            {"missing_radiance", toJson(std::optional(mode.missing))},
            {"cut_off_radiance", toJson(mode.cutOff)},
            {"rows", rows}};
}

Json toJson(const std::vector<Comparison>& comparisons, const char* place) {
    Json rows = Json::array();
    for (const Comparison& comparison : comparisons) {
        Json values = Json::array();
        for (const std::optional<double>& value : comparison.values) values.push_back(value ? Json(*value) : Json());
        rows.push_back({{place, comparison.at}, {"values", values}});
    }
    return rows;
}

/// As a photograph of a mean radiance of 0.5 would show it: a picture to look at, no measurement.
void writeDisplayed(const std::filesystem::path& path, const Image& image, float scale) {
    constexpr float kWhite = 4.0f;
    Image display = image;
    for (float& value : display.texels) {
        const float x = scale * value;
        value = std::min(x * (1.0f + x / (kWhite * kWhite)) / (1.0f + x), 1.0f);
    }
    writePng(path, display);
}

float displayScale(const Image& reference) {
    double sum = 0.0;
    for (const float value : reference.texels) sum += double{value};
    const double mean = sum / static_cast<double>(reference.texels.size());
    return mean > 0.0 ? static_cast<float>(0.5 / mean) : 1.0f;
}

}  // namespace

std::string errorCsv(const ErrorSummary& summary) {
    std::string text =
        "mode,frames,seconds,rmse,rmse_error,rmse_without_worst,rmse_without_worst_error,relative_mse,"
        "relative_mse_error,flip,flip_error,bias_squared,variance,non_finite_pixels,is_measurable\n";
    const auto pair = [](const std::optional<Estimate>& value) {
        return value ? fmt::format("{:.6g},{:.3g}", value->mean, value->error) : ",";
    };
    for (const ModeSummary& mode : summary.modes)
        for (const ErrorRow& row : mode.rows)
            text += fmt::format("\"{}\",{},{:.6g},{},{},{},{},{:.6g},{:.6g},{},{}\n", mode.name, row.frames,
                                row.seconds, pair(row.rmse), pair(row.rmseWithoutWorst), pair(row.relativeMse),
                                pair(row.flip), row.biasSquared, row.variance, row.nonFinite, row.isMeasurable ? 1 : 0);
    return text;
}

Json errorJson(const ErrorOptions& options, const ErrorRun& run, const ErrorSummary& summary) {
    Json modes = Json::array();
    for (const ModeSummary& mode : summary.modes) modes.push_back(toJson(mode));
    return {{"benchmark", "error"},
            {"scene", run.sceneName},
            {"triangles", run.triangleCount},
            {"width", run.settings.width},
            {"height", run.settings.height},
            {"machine", run.machine},
            {"settings", toJson(run.settings)},
            {"seeds", run.modes.front().checkpoints.front().images.size()},
            {"seconds_per_run", options.secondsPerRun},
            {"leaves_out_lamps", run.mask.has_value()},
            {"interrupted", run.isInterrupted},
            {"one_off_seconds",
             {{"import", run.importSeconds}, {"bvh_build", run.bvhSeconds}, {"upload", run.uploadSeconds}}},
            {"reference",
             {{"rmse", run.reference.halves ? Json(summary.referenceError) : Json()},
              {"samples_per_pixel", run.reference.samplesPerPixel},
              {"seconds", run.reference.seconds},
              {"is_given", !options.referenceFile.empty()}}},
            {"modes", modes},
            {"equal_time", toJson(summary.equalTime, "seconds")},
            {"equal_error", toJson(summary.equalError, "rmse")},
            {"warnings", run.warnings.toJson()}};
}

void writePictures(const std::filesystem::path& folder, const ErrorRun& run) {
    const std::vector<std::string> rgb = {"R", "G", "B"};
    const Image& reference = run.reference.image;
    const float scale = displayScale(reference);
    writeExr(folder / "reference.exr", {{"", rgb, reference}}, {{"manylight.scene", run.sceneName}});
    writeDisplayed(folder / "reference.png", reference, scale);
    for (size_t i = 0; i < run.modes.size(); ++i) {
        const Image& image = run.modes[i].checkpoints.back().images.front();
        const std::string stem = fmt::format("mode-{}", i + 1);
        writeExr(folder / (stem + ".exr"), {{"", rgb, image}},
                 {{"manylight.scene", run.sceneName}, {"manylight.mode", run.modes[i].mode.name}});
        writeDisplayed(folder / (stem + ".png"), image, scale);
    }
}

}  // namespace manylight
