// manylight-capture: a headless frame, as EXR, PNG and a run report.
#include "apps/capture/capture.h"
#include "apps/common/command_line.h"

#include <fmt/format.h>

int main(int argc, char** argv) {
    using namespace manylight;
    CLI::App app{"Renders a scene without a window.", "manylight-capture"};
    addStandardOptions(app);
    app.footer(
        "Examples:\n"
        "  manylight-capture scenes/cornell_box.json -o box.png\n"
        "  manylight-capture scene.gltf -o scene.exr -o scene.png --vpls 2000 --frames 16 --report scene.json\n"
        "  manylight-capture scenes/cornell_box.json -o vpls.png --show vpls --vpls 250\n"
        "  manylight-capture moving.glb -o frames/####.png --animate 0:2:24 --frames 8\n"
        "Exit codes: 0 done, 1 something failed (file, device), 2 wrong usage.\n"
        "MANYLIGHT_VALIDATION=off|core|sync turns Vulkan's validation on.");

    CaptureOptions options;
    bool listDevices = false;
    app.add_option("scene", options.scene, "OBJ, glTF or GLB file, or a JSON sidecar");
    app.add_option("-o,--output", options.outputs, "FILE.exr (linear radiance, float) or FILE.png; may be repeated");
    app.add_option("--frames,--spp", options.frameCount,
                   "frames to average, each with new light paths and pixel samples (default: 1, or until --time or "
                   "--target-error)")
        ->check(CLI::Range(1, 1 << 24));
    app.add_option("--time", options.secondsBudget, "stop after this many seconds, but after one frame at least")
        ->check(CLI::Range(0.0, 1e9));
    app.add_option("--target-error", options.targetError,
                   "stop when the root mean square of the pixels' standard errors, over the mean of the picture, is as "
                   "small as this")
        ->check(CLI::Range(0.0, 1e9));
    app.add_flag("--side-by-side", options.sideBySide, "local, global and both, beside each other in one PNG");
    app.add_option("--aov", options.aovs, "EXR layers: normal,albedo,depth,position,material,variance,cut-off")
        ->delimiter(',');
    app.add_option("--report", options.report, "run report as JSON");
    app.add_option("--dump-graph", options.dumpGraph, "write FILE.dot and FILE.json: the frame graph");
    app.add_option("--dump-pass", options.dumpPass, "write every image this pass wrote beside the output, as EXR");
    app.add_option("--at", options.sceneTime, "the scene's animation so many seconds after its start")
        ->check(CLI::Range(0.0, 1e9));
    app.add_option(
           "--animate", options.animate,
           "a picture for every moment of the animation: 0:2:24 is 0 to 2 s at 24 a second; # signs in the names "
           "of outputs become its number")
        ->type_name("FROM:TO:RATE")
        ->excludes("--at");
    addInstancesOption(app, options.instances);
    app.add_flag("--explain", options.explain, "print what this scene does not need, and why");
    app.add_option("--device", options.device, "index or part of the name of a Vulkan device");
    app.add_flag("--list-devices", listDevices, "print the Vulkan devices and exit");
    addSettingOptions(app, options.settings);

    return runProgram(app, argc, argv, [&] {
        if (listDevices) {
            const gpu::Instance instance(gpu::validationFromEnvironment());
            fmt::print("{}", gpu::describeDevices(instance.devices()));
            return;
        }
        capture(options);
    });
}
