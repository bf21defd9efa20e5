#include "apps/bench/fps.h"

#include "apps/bench/fps_outputs.h"
#include "apps/bench/fps_table.h"
#include "apps/bench/plot.h"

#include <memory>

namespace manylight {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  manylight-bench fps scenes/cornell_box.json --size 256x192 --vpls 20,50,90,200\n"
    "  manylight-bench fps scene.obj --shadows off --csv fps.csv --json fps.json --plot fps.png\n"
    "  manylight-bench fps scene.gltf --techniques deferred --csv - > fps.csv\n"
    "The plot needs Python's matplotlib; MANYLIGHT_PYTHON names another interpreter than /usr/bin/python3.";

/// Throws Error before anything is measured.
void checkOutputs(const FpsOptions& options) {
    checkTableFiles(options.files);
    checkPlotFile(options.plot);
}

void fps(const FpsOptions& options) {
    if (options.scene.empty()) failUsage("no scene given: expected an OBJ, glTF, GLB or JSON file");
    checkOutputs(options);
    const FpsRun run = measureFps(options);
    printWarnings(run.warnings);
    const FpsSummary summary = summarise(run);
    const Json json = fpsJson(options, run, summary);
    writeTables(options.files, fpsTable(options, run, summary), fpsCsv(summary), json);
    if (!options.plot.empty()) drawPlot("plot_fps.py", json, options.plot);
    if (run.isInterrupted) fail("interrupted: the results are of what was measured before");
}

/// A comma-separated list, so that a scene may follow it.
template <typename T>
void addList(CLI::App& parser, const char* option, std::vector<T>& list, const char* values, const char* help,
             const CLI::Validator& check) {
    parser.add_option(option, list, help)->delimiter(',')->allow_extra_args(false)->check(check)->option_text(values);
}

/// CLI::Range lets NaN pass.
std::string checkSeconds(const std::string& text) {
    double seconds = 0.0;
    const bool isNumber = CLI::detail::lexical_cast(text, seconds);
    return isNumber && seconds >= 0.0 && seconds <= 1e6 ? "" : text + ": expected seconds from 0 to 1000000";
}

void addMeasureOptions(CLI::App& parser, FpsOptions& options) {
    const CLI::Range counts(0, 1 << 21);
    parser.add_option("scene", options.scene, "OBJ, glTF or GLB file, or a JSON sidecar")->type_name("FILE");
    addList(parser, "--vpls", options.vplCounts, "N,... [20,50,90,200,500,800]", "VPL counts", counts);
    addList(parser, "--shadowed-vpls", options.shadowedVplCounts, "N,...",
            "VPL counts with shadows; otherwise those of --vpls, on a software driver up to 90 only", counts);
    addList(parser, "--techniques", options.techniques, "forward,forward-prepass,deferred,interleaved,filtered",
            "what to compare", CLI::IsMember({"forward", "forward-prepass", "deferred", "interleaved", "filtered"}));
    addList(parser, "--shadows", options.shadows, "off,on", "VPLs without shadow rays, with them, or both",
            CLI::IsMember({"off", "on"}));
    parser.add_option("--seconds", options.secondsPerCell, "time for each combination, at least")
        ->check(checkSeconds)
        ->option_text("SECONDS [2]");
    parser.add_option("--frames", options.framesPerCell, "frames for each combination, at least")
        ->check(CLI::Range(1, 1 << 20))
        ->option_text("N [5]");
    parser
        .add_option("--rounds", options.roundCount, "turns that each combination takes, to share the machine's drift")
        ->check(CLI::Range(1, 1000))
        ->option_text("N [3]");
    parser.add_option("--device", options.device, "index or part of the name of a Vulkan device")->type_name("NAME");
}

}  // namespace

BenchCommand addFpsCommand(CLI::App& app) {
    CLI::App* parser = app.add_subcommand("fps", "frames per second over VPL counts, forward against deferred");
    const auto options = std::make_shared<FpsOptions>();
    parser->footer(kExamples);
    parser->get_formatter()->column_width(38);
    addMeasureOptions(*parser, *options);
    addTableOptions(*parser, options->files);
    parser->add_option("--plot", options->plot, "FPS, ms and ratios over VPL counts, as .png or .svg")
        ->type_name("FILE")
        ->group("Output");
    addSettingOptions(*parser, options->settings,
                      {"technique", "vpls", "shadows", "interleave", "filter", "gather-step", "quality", "show", "vpl-dots"});
    return {parser, [options] { fps(*options); }};
}

}  // namespace manylight
