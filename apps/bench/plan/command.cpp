#include "apps/bench/plan/command.h"

#include "apps/bench/plan/table.h"
#include "engine/core/error.h"

#include <memory>

namespace manylight {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  manylight-bench plan scenes/cornell_box.json\n"
    "  manylight-bench plan scenes/*.json --size 256x192 --frames 20 --csv plan.csv\n"
    "Exit code 1 also if something that was left out changed a picture by more than rounding.";

void plan(const PlanOptions& options) {
    if (options.scenes.empty()) failUsage("no scene given: expected OBJ, glTF, GLB or JSON files");
    checkTableFiles(options.files);
    const PlanRun run = measurePlans(options);
    if (!run.scenes.empty()) writeTables(options.files, planTable(run), planCsv(run), planJson(options, run));
    if (run.isInterrupted) fail("interrupted: the results are of the scenes that were measured before");
    if (const size_t count = otherPictures(run))
        fail("{} picture(s) changed by more than {} with what the plan leaves out", count, kPlanTolerance);
}

}  // namespace

BenchCommand addPlanCommand(CLI::App& app) {
    CLI::App* parser = app.add_subcommand("plan", "what leaving out saves: each scene with each decision undone");
    const auto options = std::make_shared<PlanOptions>();
    parser->footer(kExamples);
    parser->get_formatter()->column_width(38);
    parser->add_option("scenes", options->scenes, "OBJ, glTF or GLB files, or JSON sidecars")->type_name("FILE");
    parser->add_option("--decisions", options->decisions, "those to undo, as --explain names them; otherwise all")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("NAME,...");
    addInstancesOption(*parser, options->instances);
    parser->add_option("--frames", options->frames, "frames of every variant, in turns")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    parser->add_flag(
        "--all-outputs", options->wantsAllOutputs,
        "ask each for the variance, the light cut off and the displayed picture: what is left out is then up to "
        "the scene");
    parser->add_option("--device", options->device, "index or part of the name of a Vulkan device")->type_name("NAME");
    addTableOptions(*parser, options->files);
    addSettingOptions(*parser, options->settings, {"plan", "plan-keeps", "show", "vpl-dots"});
    return {parser, [options] { plan(*options); }};
}

}  // namespace manylight
