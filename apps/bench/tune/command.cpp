#include "apps/bench/tune/command.h"

#include "apps/bench/tune/table.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/techniques/settings.h"

#include <fmt/format.h>

#include <memory>

namespace manylight {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  manylight-bench tune\n"
    "  manylight-bench tune scenes/cornell_box.json --size 1280x720 --turns 20\n"
    "  manylight-bench tune --tunables ray-threads,nodes-any-hit -o tuning.json\n"
    "Every program reads the file from then on; MANYLIGHT_TUNING=FILE names another, MANYLIGHT_TUNING=off none.";

/// Where the tuning goes.
std::optional<std::filesystem::path> outputOf(const TuneOptions& options) {
    if (!options.output.empty()) return options.output;
    return gpu::tuningFile();
}

/// The default needs no entry, and where it is best none may be left.
void keepTuning(const std::optional<std::filesystem::path>& file, const TuneRun& run) {
    const bool isWorth = isWorthKeeping(run);
    if (file && (isWorth || isRegularFile(*file)))
        gpu::writeTuning(*file, run.key, isWorth ? std::optional(run.tuning) : std::nullopt);
    const std::string where = file ? file->string() : "no file: MANYLIGHT_TUNING=off, or no home";
    fmt::print(stderr, "{} ({})\n", isWorth ? "tuning kept" : "the default is as fast as any: no tuning kept", where);
}

void tune(const TuneOptions& options) {
    RenderSettings probe;
    applySetting(probe, "size", options.size);  // or says what is wrong with it
    checkTableFiles(options.files);
    if (!options.output.empty()) requireWritable(options.output);
    const TuneRun run = measureTuning(options);
    if (run.isInterrupted) fail("interrupted: no tuning was kept");
    writeTables(options.files, tuneTable(run), tuneCsv(run), tuneJson(options, run));
    keepTuning(outputOf(options), run);
    if (const size_t count = otherPictures(run))
        fail("{} value(s) that changed a picture: none of them was chosen", count);
}

}  // namespace

BenchCommand addTuneCommand(CLI::App& app) {
    CLI::App* parser = app.add_subcommand("tune", "what suits this device: sizes of workgroups and the like");
    const auto options = std::make_shared<TuneOptions>();
    parser->footer(kExamples);
    parser->get_formatter()->column_width(38);
    parser->add_option("scenes", options->scenes, "scenes to measure on; otherwise the Cornell box and the courtyard")
        ->type_name("FILE");
    parser->add_option("--tunables", options->tunables, "those to measure; otherwise all")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("NAME,...");
    parser->add_option("--turns", options->turns, "in each of which every value renders a frame")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    parser->add_option("--size", options->size, "of the pictures")->type_name("WxH")->capture_default_str();
    parser->add_option("-o,--output", options->output, "where the tuning is kept; otherwise where programs read it")
        ->type_name("FILE");
    parser->add_option("--device", options->device, "index or part of the name of a Vulkan device")->type_name("NAME");
    addTableOptions(*parser, options->files);
    return {parser, [options] { tune(*options); }};
}

}  // namespace manylight
