#include "apps/compare/numbers.h"

#include <fmt/format.h>

namespace manylight {
namespace {

std::string line(std::string_view name, std::string_view value, std::string_view note = {}) {
    return fmt::format("{:<26}{:>12}{}{}\n", name, value, note.empty() ? "" : "  ", note);
}

std::string number(double value) { return fmt::format("{:.6g}", value); }

std::string numberOr(const std::optional<double>& value) { return value ? number(*value) : "undefined"; }

const char* flipName(FlipKind kind) { return kind == FlipKind::Hdr ? "HDR-FLIP" : "LDR-FLIP"; }

std::string flipText(const CompareOptions& options, const CompareNumbers& numbers) {
    if (numbers.flipKind == FlipKind::Off) return "";
    if (!numbers.flip) return line(flipName(numbers.flipKind), "undefined", "the reference is black");
    const FlipExposures& exposures = numbers.flip->exposures;
    std::string note = fmt::format("{:.2f} pixels per degree", options.pixelsPerDegree);
    if (numbers.flipKind == FlipKind::Hdr)
        note += fmt::format(", {} exposures from {:+.2f} to {:+.2f} stops", exposures.count, exposures.start,
                            exposures.stop);
    return line(flipName(numbers.flipKind), number(numbers.flip->mean), note);
}

std::string meansText(const ErrorReport& error) {
    std::string text = fmt::format("\n{:<26}{:>12}{:>12}{:>12}\n", "mean", "red", "green", "blue");
    const auto row = [&](std::string_view name, const auto& value) {
        text += fmt::format("{:<26}{:>12}{:>12}{:>12}\n", name, value(0), value(1), value(2));
    };
    row("  picture", [&](size_t c) { return number(error.meanTest[c]); });
    row("  reference", [&](size_t c) { return number(error.meanReference[c]); });
    row("  ratio", [&](size_t c) { return numberOr(meanRatio(error, c)); });
    return text;
}

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json flipJson(const CompareOptions& options, const CompareNumbers& numbers) {
    if (numbers.flipKind == FlipKind::Off) return nullptr;
    Json json = {{"kind", numbers.flipKind == FlipKind::Hdr ? "hdr" : "ldr"},
                 {"pixels_per_degree", options.pixelsPerDegree},
                 {"mean", numbers.flip ? Json(numbers.flip->mean) : Json()}};
    if (numbers.flip && numbers.flipKind == FlipKind::Hdr) {
        const FlipExposures& exposures = numbers.flip->exposures;
        json["exposures"] = {{"start", exposures.start}, {"stop", exposures.stop}, {"count", exposures.count}};
    }
    return json;
}

}  // namespace

std::string numbersToText(const CompareOptions& options, const CompareNumbers& numbers) {
    const ErrorReport& error = numbers.error;
    std::string text = fmt::format("picture    {}\nreference  {}\n", options.test.string(), options.reference.string());
    text += fmt::format("{} x {} pixels, {} compared", numbers.width, numbers.height, error.pixels);
    if (error.maskedOut > 0) text += fmt::format(", {} masked out", error.maskedOut);
    if (error.nonFinite > 0)
        text += fmt::format(", {} left out as not finite ({} in the picture, {} in the reference)", error.nonFinite,
                            error.nonFiniteTest, error.nonFiniteReference);
    const std::string worst = fmt::format("{} pixels", error.worstPixels);
    text += "\n\n" + line("RMSE", number(error.rmse));
    text += line("  without the worst 0.1 %", number(error.rmseWithoutWorst), worst);
    text +=
        line("  share of the worst 0.1 %", fmt::format("{:.2f} %", 100.0 * error.worstShare), "of the squared error");
    text += line("relative MSE", numberOr(error.relativeMse),
                 "(v - r)² / (r² + 0.01), over the reference's mean luminance");
    text += line("SMAPE", numberOr(error.smape), "|v - r| / (|v| + |r| + 0.01), likewise");
    return text + flipText(options, numbers) + meansText(error);
}

Json numbersToJson(const CompareOptions& options, const CompareNumbers& numbers, const Warnings& warnings) {
    const ErrorReport& error = numbers.error;
    const auto ratio = [&](size_t c) { return orNull(meanRatio(error, c)); };
    return {{"picture", options.test.string()},
            {"reference", options.reference.string()},
            {"layer", options.layer},
            {"width", numbers.width},
            {"height", numbers.height},
            {"pixels", error.pixels},
            {"masked_out", error.maskedOut},
            {"non_finite", error.nonFinite},
            {"non_finite_picture", error.nonFiniteTest},
            {"non_finite_reference", error.nonFiniteReference},
            {"rmse", error.rmse},
            {"rmse_without_worst", error.rmseWithoutWorst},
            {"worst_pixels", error.worstPixels},
            {"worst_share", error.worstShare},
            {"relative_mse", orNull(error.relativeMse)},
            {"smape", orNull(error.smape)},
            {"flip", flipJson(options, numbers)},
            {"mean_luminance_reference", error.meanLuminanceReference},
            {"mean_picture", error.meanTest},
            {"mean_reference", error.meanReference},
            {"mean_ratio", {ratio(0), ratio(1), ratio(2)}},
            {"warnings", warnings.toJson()}};
}

}  // namespace manylight
