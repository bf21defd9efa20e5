#include "apps/bench/stability/command.h"

#include "apps/bench/stability/run.h"
#include "apps/bench/table_files.h"
#include "engine/core/error.h"

#include <fmt/format.h>

#include <memory>

namespace manylight {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  manylight-bench stability --quick\n"
    "  manylight-bench stability --case furnace --case thin-walls --json stability.json\n"
    "  manylight-bench stability --crack scene.obj\n"
    "  MANYLIGHT_VALIDATION=sync manylight-bench stability --csv stability.csv\n"
    "Scenes are generated: no files are needed. Ctrl-C ends it with the cases that are complete.\n"
    "Exit code 1 also if a case failed.";

struct StabilityOptions {
    std::vector<std::string> cases;
    bool onlyQuick = false;
    bool lists = false;
    std::string crackScene;
    std::string device;
    TableFiles files;
};

void stability(const StabilityOptions& options) {
    if (options.lists) {
        fmt::print("{}", stabilityList());
        return;
    }
    const std::vector<const StabilityCase*> cases = chooseCases(options.cases, options.onlyQuick);
    checkTableFiles(options.files);
    const StabilityRun run = options.crackScene.empty() ? runStability(cases, options.device)
                                                        : runCrackTest(options.crackScene, options.device);
    writeTables(options.files, stabilityTable(run), stabilityCsv(run), stabilityJson(run));
    if (const size_t failures = failureCount(run)) fail("{} case(s) of the stability suite failed", failures);
    if (run.isInterrupted) fail("interrupted: {} of {} cases ran", run.outcomes.size(), cases.size());
}

}  // namespace

BenchCommand addStabilityCommand(CLI::App& app) {
    CLI::App* parser = app.add_subcommand("stability", "stiff and extreme cases: what must happen, and what did");
    const auto options = std::make_shared<StabilityOptions>();
    parser->footer(kExamples);
    parser->get_formatter()->column_width(38);
    parser->add_option("--case", options->cases, "run this case; may be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME");
    parser->add_flag("--quick", options->onlyQuick, "the quick half: about two minutes on two cores");
    parser->add_flag("--list", options->lists, "print the cases and exit");
    parser->add_option("--crack", options->crackScene, "instead: rays at the edges of this scene must not slip through")
        ->type_name("SCENE");
    parser->add_option("--device", options->device, "index or part of the name of a Vulkan device")->type_name("NAME");
    addTableOptions(*parser, options->files);
    return {parser, [options] { stability(*options); }};
}

}  // namespace manylight
