#include "apps/bench/error.h"

#include "apps/bench/error_outputs.h"
#include "apps/bench/plot.h"
#include "engine/core/error.h"
#include "engine/core/file.h"

#include <memory>

namespace manylight {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  manylight-bench error scenes/cornell_box.json --size 256x256 --vpls 64\n"
    "  manylight-bench error scene.gltf --mode clamp=compensate --mode technique=path-tracer --plot error.png\n"
    "  manylight-bench error scene.obj --mode clamp=off,vpls=16 --mode clamp=off,vpls=256 --seconds 20\n"
    "Without --mode: clamp=off, clamp=bound, clamp=compensate and technique=path-tracer.\n"
    "Ctrl-C ends it with the seeds that are complete. Exit code 1 also if a pixel was not finite.";

/// Throws Error before anything is measured.
void checkOutputs(const ErrorOptions& options) {
    checkTableFiles(options.files);
    if (!options.pictureFolder.empty()) {
        std::error_code failure;
        std::filesystem::create_directories(options.pictureFolder, failure);
        requireWritable(std::filesystem::path(options.pictureFolder) / "reference.exr");
    }
    checkPlotFile(options.plot);
}

void error(const ErrorOptions& options) {
    if (options.scene.empty()) failUsage("no scene given: expected an OBJ, glTF, GLB or JSON file");
    checkOutputs(options);
    const ErrorRun run = measureError(options);
    printWarnings(run.warnings);
    const ErrorSummary summary = summarise(run, options);
    const Json json = errorJson(options, run, summary);
    writeTables(options.files, errorTable(options, run, summary), errorCsv(summary), json);
    if (!options.pictureFolder.empty()) writePictures(options.pictureFolder, run);
    if (!options.plot.empty()) drawPlot("plot_error.py", json, options.plot);
    uint64_t nonFinite = 0;
    for (const ModeSummary& mode : summary.modes)
        for (const ErrorRow& row : mode.rows) nonFinite += row.nonFinite;
    if (nonFinite > 0) fail("{} pixels of the measured pictures are not finite", nonFinite);
    if (run.isInterrupted) fail("interrupted: the results are of the seeds that were complete");
}

/// CLI::Range lets NaN pass.
CLI::Validator numberFrom(double low, double high) {
    return CLI::Validator(
        [low, high](const std::string& text) {
            double value = 0.0;
            const bool isNumber = CLI::detail::lexical_cast(text, value);
            return isNumber && value >= low && value <= high ? std::string()
                                                             : fmt::format("{}: expected {} to {}", text, low, high);
        },
        "");
}

}  // namespace

BenchCommand addErrorCommand(CLI::App& app) {
    CLI::App* parser = app.add_subcommand("error", "error against run time, each technique against a reference");
    const auto options = std::make_shared<ErrorOptions>();
    parser->footer(kExamples);
    parser->get_formatter()->column_width(38);
    parser->add_option("scene", options->scene, "OBJ, glTF or GLB file, or a JSON sidecar")->type_name("FILE");
    parser->add_option("--mode", options->modes, "settings of one mode, option=value,...; may be repeated")
        ->allow_extra_args(false)
        ->type_name("SETTINGS");
    parser->add_option("--seconds", options->secondsPerRun, "time of every mode and seed")
        ->check(numberFrom(1e-3, 1e6))
        ->capture_default_str();
    parser->add_option("--seeds", options->seedCount, "independent runs of every mode")
        ->check(CLI::Range(2, 4096))
        ->capture_default_str();
    parser->add_option("--reference-seconds", options->referenceSeconds, "time to make the reference, or to refine it")
        ->check(numberFrom(0.0, 1e7))
        ->capture_default_str();
    parser->add_option("--reference-error", options->referenceError, "good enough: its RMSE over its mean")
        ->check(numberFrom(0.0, 1.0))
        ->capture_default_str();
    parser->add_option("--reference", options->referenceFile, "an EXR of the same size instead")->type_name("FILE");
    parser->add_flag("--leave-out-lamps", options->leaveOutLamps,
                     "leave pixels that see an emitter out of all numbers: their edges outweigh all else");
    parser->add_flag("!--no-flip", options->flip, "leave out FLIP, which takes longest to compute");
    parser->add_option("--device", options->device, "index or part of the name of a Vulkan device")->type_name("NAME");
    addTableOptions(*parser, options->files);
    parser->add_option("--plot", options->plot, "error over time, as .png or .svg")->type_name("FILE")->group("Output");
    parser->add_option("--pictures", options->pictureFolder, "folder for the last pictures and their differences")
        ->type_name("FOLDER")
        ->group("Output");
    addSettingOptions(*parser, options->settings, {"show", "vpl-dots", "seed"});
    return {parser, [options] { error(*options); }};
}

}  // namespace manylight
