#include "apps/bench/plan/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace manylight {
namespace {

double mebibytes(uint64_t bytes) { return static_cast<double>(bytes) / (1u << 20); }

/// Median over frames of the ratio to the planned variant's frame, which ran in the same turn.
struct Ratio {
    Spread frames;
    Interval ofMedian;
};

Ratio ratioOf(const PlanVariant& variant, const PlanVariant& planned) {
    std::vector<double> ratios;
    for (size_t i = 0; i < variant.gpuMilliseconds.size(); ++i)
        ratios.push_back(variant.gpuMilliseconds[i] / planned.gpuMilliseconds[i]);
    return {spreadOf(ratios), intervalOfMedian(ratios)};
}

std::string pictureText(const PictureDifference& difference) {
    if (difference.sameBytes) return "same bytes";
    return fmt::format("{:.1e}{}", difference.relative, difference.relative > kPlanTolerance ? " DIFFERS" : "");
}

/// Passes that take a hundredth of the frame or more, in order.
std::string passText(const PlanVariant& variant) {
    const double frame = median(variant.gpuMilliseconds);
    std::string text;
    for (const auto& [pass, times] : variant.passes)
        if (const double milliseconds = median(times); milliseconds >= 0.01 * frame)
            text += fmt::format("{}{} {:.2f}", text.empty() ? "" : ", ", pass, milliseconds);
    return text;
}

std::string sceneText(const PlanScene& scene) {
    const PlanVariant& planned = scene.variants.front();
    std::string text =
        fmt::format("\n{}: {} triangles, {}x{}, {}, {} VPLs\n", scene.file, scene.triangles, scene.settings.width,
                    scene.settings.height, name(scene.settings.technique), scene.settings.vplCount);
    text +=
        fmt::format("  {:<38}{:>9}{:>24}{:>18}{:>9}{:>7}{:>18}{:>9}  {}\n", "kept though not needed", "ms/frame",
                    "ratio [95 % certain]", "(5 to 95 %)", "MiB", "ratio", "pipelines (other)", "start s", "picture");
    for (const PlanVariant& variant : scene.variants) {
        const Ratio ratio = ratioOf(variant, planned);
        text += fmt::format(
            "  {:<38}{:>9.2f}{:>8.3f} [{:.3f}, {:.3f}] ({:.3f} .. {:.3f}){:>9.2f}{:>7.3f}{:>18}{:>9.3f}  {}{}\n",
            variant.name, median(variant.gpuMilliseconds), ratio.frames.median, ratio.ofMedian.low, ratio.ofMedian.high,
            ratio.frames.p5, ratio.frames.p95, mebibytes(variant.deviceBytes),
            static_cast<double>(variant.deviceBytes) / static_cast<double>(planned.deviceBytes),
            fmt::format("{} ({})", variant.pipelines, variant.pipelinesUnlikePlanned), variant.startSeconds,
            pictureText(variant.difference), isSameWork(variant, planned) ? ", same work" : "");
    }
    for (const PlanVariant* variant : {&scene.variants.front(), &scene.variants.back()})
        text += fmt::format("  ms in the passes, {}: {}\n", variant->name, passText(*variant));
    for (const PlanVariant& variant : scene.variants)
        if (!variant.reason.empty() && &variant != &scene.variants.back())
            text += fmt::format("  left out: {}; {}\n", variant.name, variant.reason);
    return text;
}

Json toJson(const PlanVariant& variant, const PlanVariant& planned) {
    Json passes = Json::object();
    for (const auto& [pass, times] : variant.passes) passes[pass] = median(times);
    const Spread time = spreadOf(variant.gpuMilliseconds);
    const auto [ratio, ofMedian] = ratioOf(variant, planned);
    return {{"kept", variant.name},
            {"reason", variant.reason},
            {"milliseconds", {{"median", time.median}, {"p5", time.p5}, {"p95", time.p95}}},
            {"time_ratio", {{"median", ratio.median}, {"p5", ratio.p5}, {"p95", ratio.p95}}},
            {"time_ratio_95_percent_certain", {ofMedian.low, ofMedian.high}},
            {"pass_milliseconds", passes},
            {"device_bytes", variant.deviceBytes},
            {"pipelines", variant.pipelines},
            {"pipelines_unlike_planned", variant.pipelinesUnlikePlanned},
            {"passes_unlike_planned", variant.passesUnlikePlanned},
            {"same_work", isSameWork(variant, planned)},
            {"start_seconds", variant.startSeconds},
            {"same_bytes", variant.difference.sameBytes},
            {"relative_difference", variant.difference.relative}};
}

}  // namespace

std::string planTable(const PlanRun& run) {
    const Json& machine = run.machine;
    const auto [low, high] = std::ranges::minmax(run.calibration);
    std::string text = fmt::format("What leaving out saves\n  device       {}, Vulkan {}, driver {}\n",
                                   machine["device"].get<std::string>(), machine["vulkan"].get<std::string>(),
                                   machine["driver"].get<std::string>());
    text += fmt::format("  calibration  a C++ loop took {:.1f} to {:.1f} ms: the machine's own noise\n", low, high);
    for (const PlanScene& scene : run.scenes) text += sceneText(scene);
    text +=
        "\nms: GPU time, medians of frames taken in turns; ratios to the plan's own, of frames of the same turn: the "
        "median,\n"
        "where it lies with 95 % confidence if frames are independent, and how single frames spread. MiB: all that a "
        "renderer\n"
        "allocates. pipelines: how many, and those that either has and the other, as planned, has not. same work: no "
        "such "
        "pipeline\nor pass, the same memory and picture. start: renderer and first frame, with warm caches. picture: "
        "mean absolute difference over the mean.\n";
    return text;
}

std::string planCsv(const PlanRun& run) {
    std::string text =
        "scene,kept,milliseconds,time_ratio,device_bytes,pipelines,pipelines_unlike_planned,passes_unlike_planned,"
        "start_seconds,same_bytes,relative_difference\n";
    for (const PlanScene& scene : run.scenes)
        for (const PlanVariant& variant : scene.variants)
            text += fmt::format("\"{}\",\"{}\",{:.4f},{:.4f},{},{},{},{},{:.4f},{},{:.3e}\n", scene.file, variant.name,
                                median(variant.gpuMilliseconds), ratioOf(variant, scene.variants.front()).frames.median,
                                variant.deviceBytes, variant.pipelines, variant.pipelinesUnlikePlanned,
                                variant.passesUnlikePlanned, variant.startSeconds, variant.difference.sameBytes,
                                variant.difference.relative);
    return text;
}

Json planJson(const PlanOptions& options, const PlanRun& run) {
    Json scenes = Json::array();
    for (const PlanScene& scene : run.scenes) {
        Json variants = Json::array();
        for (const PlanVariant& variant : scene.variants) variants.push_back(toJson(variant, scene.variants.front()));
        scenes.push_back({{"scene", scene.name},
                          {"file", scene.file},
                          {"triangles", scene.triangles},
                          {"settings", toJson(scene.settings)},
                          {"variants", variants}});
    }
    return {{"benchmark", "plan"},
            {"machine", run.machine},
            {"frames", options.frames},
            {"calibration_milliseconds", run.calibration},
            {"interrupted", run.isInterrupted},
            {"scenes", scenes}};
}

size_t otherPictures(const PlanRun& run) {
    size_t count = 0;
    for (const PlanScene& scene : run.scenes)
        count += static_cast<size_t>(std::ranges::count_if(scene.variants, [](const PlanVariant& variant) {
            return !(variant.difference.sameBytes || variant.difference.relative <= kPlanTolerance);
        }));
    return count;
}

}  // namespace manylight
