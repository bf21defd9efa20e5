#include "apps/bench/rays.h"

#include "apps/bench/rays_summary.h"
#include "apps/common/command_line.h"
#include "engine/core/error.h"

#include <memory>

namespace manylight {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  manylight-bench rays scenes/cornell_box.json\n"
    "  manylight-bench rays courtyard.json --size 1024x768 --repetitions 30 --json rays.json\n"
    "Exit code 1 also if a ray hits where Embree's robust mode says it misses, or the other way round.";

void rays(const RaysOptions& options) {
    if (options.scene.empty()) failUsage("no scene given: expected an OBJ, glTF, GLB or JSON file");
    checkTableFiles(options.files);
    const RaysRun run = measureRays(options);
    writeTables(options.files, raysTable(options, run), raysCsv(run), raysJson(options, run));
    if (const uint64_t wrong = wrongHits(run))
        fail("{}: {} ray(s) met something else than in Embree's robust mode", options.scene.string(), wrong);
}

}  // namespace

BenchCommand addRaysCommand(CLI::App& app) {
    CLI::App* parser = app.add_subcommand("rays", "ray casting: speed beside Embree's, and every hit compared");
    const auto options = std::make_shared<RaysOptions>();
    parser->footer(kExamples);
    parser->get_formatter()->column_width(38);
    parser->add_option("scene", options->scene, "OBJ, glTF or GLB file, or a JSON sidecar");
    parser->add_option("--size", options->size, "one primary ray per pixel")->capture_default_str();
    parser->add_option("--camera", options->camera, "index of the scene's camera");
    addInstancesOption(*parser, options->instances);
    parser->add_option("--rays", options->rays, "ours by shaders (software) or by the device (hardware)")
        ->check(CLI::IsMember({"auto", "software", "hardware"}))
        ->capture_default_str();
    parser->add_option("--repetitions", options->repetitions, "times that every set is traced")
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    parser->add_option("--threads", options->threadCount, "threads for Embree; otherwise all that the host has")
        ->check(CLI::Range(1, 1024));
    parser->add_option("--seed", options->seed, "chooses lights and directions");
    parser->add_option("--device", options->device, "index or part of the name of a Vulkan device");
    addTableOptions(*parser, options->files);
    return {parser, [options] { rays(*options); }};
}

}  // namespace manylight
