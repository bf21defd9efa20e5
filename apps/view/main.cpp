// manylight-view: a window with a free camera and live settings.
#include "apps/view/viewer.h"

#include <map>

int main(int argc, char** argv) {
    using namespace manylight;
    CLI::App app{"Shows a scene in a window.", "manylight-view"};
    addStandardOptions(app);
    app.footer(
        "Keys: w a s d q e and the mouse move, p plays an animation, z takes back changes of\n"
        "lights, f1 lists the others, tab hides the panels.\n"
        "Examples:\n"
        "  manylight-view scenes/cornell_box.json\n"
        "  manylight-view scene.gltf --size 1280x720 --vpls 200 --budget 30\n"
        "  manylight-view scenes/cornell_box.json --compare split\n"
        "  manylight-view moving.glb --play on --speed 0.5\n"
        "  xvfb-run -a manylight-view scenes/cornell_box.json --script tour.txt\n"
        "Exit codes: 0 done, 1 something failed (file, device, no display), 2 wrong usage.\n"
        "MANYLIGHT_VALIDATION=off|core|sync turns Vulkan's validation on.");

    ViewerOptions options;
    const std::map<std::string, PresentMode> modes = {
        {"fifo", PresentMode::Fifo}, {"mailbox", PresentMode::Mailbox}, {"immediate", PresentMode::Immediate}};
    app.add_option("scene", options.scene, "OBJ, glTF or GLB file, or a JSON sidecar");
    app.add_option("--script", options.script, "do what FILE says, a command a line: see docs/viewer.md");
    app.add_option("--reference", options.reference, "FILE.exr that --compare difference takes as the truth");
    app.add_option("--watch-shaders", options.watchShaders,
                   "source tree: rebuild shaders that change there, with glslangValidator");
    app.add_option("--present", options.presentMode, "how frames follow each other, where the window system has it")
        ->transform(CLI::CheckedTransformer(modes, CLI::ignore_case).description(""))
        ->type_name("fifo|mailbox|immediate");
    addInstancesOption(app, options.instances);
    app.add_option("--device", options.device, "index or part of the name of a Vulkan device");
    addSettingOptions(app, options.settings);
    addOptions(app, viewSettingHelps(), options.viewSettings, "Window");

    return runProgram(app, argc, argv, [&] {
        Viewer viewer(options);
        viewer.run();
    });
}
