// manylight-bench: timings and errors, as text tables, CSV, JSON and plots.
#include "apps/bench/error.h"
#include "apps/bench/fps.h"
#include "apps/bench/plan/command.h"
#include "apps/bench/rays.h"
#include "apps/bench/stability/command.h"
#include "apps/bench/tune/command.h"
#include "apps/common/command_line.h"

#include <fmt/format.h>

int main(int argc, char** argv) {
    using namespace manylight;
    CLI::App app{"Measures how fast Manylight is, and how right.", "manylight-bench"};
    addStandardOptions(app);
    app.require_subcommand(0, 1);
    app.footer(
        "Examples:\n"
        "  manylight-bench fps scenes/cornell_box.json\n"
        "  manylight-bench fps scene.obj --vpls 20,200 --shadows off --size 640x360 --plot fps.png\n"
        "  manylight-bench rays courtyard.json --csv rays.csv\n"
        "  manylight-bench error scenes/cornell_box.json --plot error.png\n"
        "  manylight-bench plan scenes/cornell_box.json courtyard.json\n"
        "  manylight-bench stability --quick\n"
        "  manylight-bench tune\n"
        "  manylight-bench fps --help\n"
        "Exit codes: 0 done, 1 something failed (file, device), 2 wrong usage.");
    bool listDevices = false;
    app.add_flag("--list-devices", listDevices, "print the Vulkan devices and exit");

    const std::vector<BenchCommand> commands = {
        addFpsCommand(app),
        addRaysCommand(app),
        addErrorCommand(app),
        addPlanCommand(app),
        addStabilityCommand(app),
        addTuneCommand(app),
    };

    return runProgram(app, argc, argv, [&] {
        if (listDevices) {
            const gpu::Instance instance(gpu::validationFromEnvironment());
            fmt::print("{}", gpu::describeDevices(instance.devices()));
            return;
        }
        for (const BenchCommand& command : commands)
            if (command.parser->parsed()) return command.run();
        failUsage("no subcommand given (try --help)");
    });
}
