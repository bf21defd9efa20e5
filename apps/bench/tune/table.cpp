#include "apps/bench/tune/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace manylight {
namespace {

std::string spreadText(const std::vector<double>& ratios) {
    const Spread ratio = spreadOf(ratios);
    return fmt::format("{:.3f} ({:.3f} .. {:.3f})", ratio.median, ratio.p5, ratio.p95);
}

/// Of the fastest turns: what a busy machine leaves of a ratio.
double ratioOfFastest(const TunedValue& value, const TuneCandidate& candidate) {
    return std::ranges::min(candidate.milliseconds) / std::ranges::min(value.candidates.front().milliseconds);
}

Json toJson(const Spread& spread) { return {{"median", spread.median}, {"p5", spread.p5}, {"p95", spread.p95}}; }

std::string tunableText(const TunedValue& value) {
    std::string text;
    for (size_t i = 0; i < value.candidates.size(); ++i) {
        const TuneCandidate& candidate = value.candidates[i];
        text +=
            fmt::format("  {:<24}{:>7}{:>11.2f}{:>26}{:>9.3f}  {}{}\n", i == 0 ? value.tunable : "", candidate.value,
                        median(candidate.milliseconds), spreadText(candidate.ratios), ratioOfFastest(value, candidate),
                        i == value.chosen ? "chosen" : "", candidate.sameBytes ? "" : "OTHER PICTURE");
    }
    return text;
}

}  // namespace

std::string tuneTable(const TuneRun& run) {
    const Json& machine = run.machine;
    const auto [low, high] = std::ranges::minmax(run.calibration);
    std::string text = fmt::format("Tuning of a device\n  device       {}, Vulkan {}, driver {}\n",
                                   machine["device"].get<std::string>(), machine["vulkan"].get<std::string>(),
                                   machine["driver"].get<std::string>());
    text += fmt::format("  scenes       {}\n", fmt::join(run.scenes, ", "));
    text += fmt::format("  calibration  a C++ loop took {:.1f} to {:.1f} ms: the machine's own noise\n\n", low, high);
    text += fmt::format("  {:<24}{:>7}{:>11}{:>26}{:>9}\n", "tunable", "value", "ms", "ratio (5 to 95 %)", "fastest");
    for (const TunedValue& value : run.values) text += tunableText(value);
    if (!run.ratios.empty())
        text +=
            fmt::format("\n  whole frames with all that was chosen, to the default's: {}\n", spreadText(run.ratios));
    text += fmt::format(
        "\nms: GPU time of the passes that the tunable is about, median over turns. Ratios are to the first value, the "
        "default,\nwithin a turn; fastest: of the fastest turns of both. Another is chosen where the median is below "
        "{} and the 95 % side below 1.\n",
        kGainWorthHaving);
    return text;
}

std::string tuneCsv(const TuneRun& run) {
    std::string text =
        "tunable,value,milliseconds,time_ratio,time_ratio_p5,time_ratio_p95,fastest_ratio,same_bytes,chosen\n";
    for (const TunedValue& value : run.values)
        for (size_t i = 0; i < value.candidates.size(); ++i) {
            const TuneCandidate& candidate = value.candidates[i];
            const Spread ratio = spreadOf(candidate.ratios);
            text += fmt::format("{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{},{}\n", value.tunable, candidate.value,
                                median(candidate.milliseconds), ratio.median, ratio.p5, ratio.p95,
                                ratioOfFastest(value, candidate), candidate.sameBytes, i == value.chosen);
        }
    return text;
}

Json tuneJson(const TuneOptions& options, const TuneRun& run) {
    Json values = Json::array();
    for (const TunedValue& value : run.values) {
        Json candidates = Json::array();
        for (const TuneCandidate& candidate : value.candidates)
            candidates.push_back({{"value", candidate.value},
                                  {"milliseconds", toJson(spreadOf(candidate.milliseconds))},
                                  {"time_ratio", toJson(spreadOf(candidate.ratios))},
                                  {"fastest_ratio", ratioOfFastest(value, candidate)},
                                  {"same_bytes", candidate.sameBytes}});
        values.push_back({{"tunable", value.tunable},
                          {"what", value.what},
                          {"candidates", candidates},
                          {"chosen", value.candidates[value.chosen].value}});
    }
    return {{"benchmark", "tune"},
            {"machine", run.machine},
            {"scenes", run.scenes},
            {"size", options.size},
            {"turns", options.turns},
            {"calibration_milliseconds", run.calibration},
            {"values", values},
            {"frame_ratio", run.ratios.empty() ? Json() : toJson(spreadOf(run.ratios))},
            {"tuning", gpu::toJson(run.tuning)}};
}

size_t otherPictures(const TuneRun& run) {
    size_t count = 0;
    for (const TunedValue& value : run.values)
        count += static_cast<size_t>(std::ranges::count_if(
            value.candidates, [](const TuneCandidate& candidate) { return !candidate.sameBytes; }));
    return count;
}

bool isWorthKeeping(const TuneRun& run) { return !run.ratios.empty() && median(run.ratios) < 1.0; }

}  // namespace manylight
