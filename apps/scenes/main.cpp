// manylight-scenes: writes the scenes that Manylight generates itself.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "engine/core/error.h"
#include "engine/scene/generate/cornell_box.h"
#include "engine/scene/generate/courtyard.h"
#include "engine/scene/generate/cube.h"
#include "engine/scene/generate/forest.h"
#include "engine/scene/generate/showcase.h"

namespace {

using namespace manylight;

constexpr const char* kExamples = R"(Examples:
  manylight-scenes cornell-box -o scenes
  manylight-scenes courtyard -o /var/tmp --triangles 260000 --depth 3
  manylight-scenes courtyard -o . --light sun --seed 7
  manylight-scenes forest -o /var/tmp --triangles 5000000
  manylight-scenes showcase -o /var/tmp

Each scene becomes DIR/NAME.json, a sidecar with camera and lights, and DIR/NAME/NAME.obj with its .mtl; the forest
DIR/forest.gltf with forest.bin, the showcase DIR/showcase/showcase.gltf with its textures and environment map.
Exit status: 0 success, 1 a file cannot be written, 2 wrong usage.)";

struct Options {
    std::string folder = ".";
    CourtyardParameters courtyard;
    ForestParameters forest;
    ShowcaseParameters showcase;
    std::string light = "point";
};

CLI::App* addSceneCommand(CLI::App& app, Options& options, const char* name, const char* description) {
    CLI::App* command = app.add_subcommand(name, description);
    command->add_option("-o,--output", options.folder, "Folder to write to, created if it is missing")
        ->type_name("DIR");
    return command;
}

void addCourtyardOptions(CLI::App& command, Options& options) {
    CourtyardParameters& courtyard = options.courtyard;
    command.add_option("--triangles", courtyard.triangleTarget, "Number of triangles, at least about 5000")
        ->capture_default_str()
        ->type_name("N");
    command.add_option("--depth", courtyard.depth, "1 to 6: rows of columns, trees and ivy, surfaces behind a pixel")
        ->capture_default_str()
        ->type_name("D");
    command.add_option("--seed", courtyard.seed, "Seed of the arrangement")->capture_default_str()->type_name("S");
    command.add_option("--light", options.light, "Light in the sidecar")
        ->capture_default_str()
        ->check(CLI::IsMember({"point", "sun", "sky", "area"}))
        ->option_text("point|sun|sky|area [point]");
}

void addForestOptions(CLI::App& command, ForestParameters& forest) {
    command.add_option("--triangles", forest.triangleTarget, "Triangles of all trees, about")
        ->check(CLI::Range(uint64_t{1000}, uint64_t{1} << 32))
        ->capture_default_str()
        ->type_name("N");
    command.add_option("--tree-triangles", forest.treeTriangles, "Triangles of a tree")
        ->check(CLI::Range(200u, 1u << 22))
        ->capture_default_str()
        ->type_name("N");
    command.add_option("--kinds", forest.kinds, "Kinds of trees")->check(CLI::Range(1u, 1000u))->capture_default_str();
    command.add_option("--seed", forest.seed, "Seed of the arrangement")->capture_default_str()->type_name("S");
}

void addShowcaseOptions(CLI::App& command, ShowcaseParameters& showcase) {
    command.add_option("--seed", showcase.seed, "Seed of wood, books and leaves")
        ->capture_default_str()
        ->type_name("S");
}

void print(const std::vector<std::filesystem::path>& written) {
    for (const std::filesystem::path& path : written) fmt::print("{}\n", path.string());
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app("Writes the scenes that Manylight generates itself.", "manylight-scenes");
    app.footer(kExamples);
    app.set_version_flag("--version", "manylight-scenes " MANYLIGHT_VERSION);
    app.require_subcommand(1);
    const CLI::App* cornellBox =
        addSceneCommand(app, options, "cornell-box", "The Cornell box, from its published data");
    const CLI::App* cube = addSceneCommand(app, options, "cube", "A unit cube whose material file is missing");
    addCourtyardOptions(*addSceneCommand(app, options, "courtyard", "An arcaded courtyard by lantern light"), options);
    const CLI::App* forest =
        addSceneCommand(app, options, "forest", "A wood at night: a few kinds of trees, repeated by instances");
    addForestOptions(*app.get_subcommand("forest"), options.forest);
    const CLI::App* showcase =
        addSceneCommand(app, options, "showcase", "A room at dusk that needs everything the engine can leave out");
    addShowcaseOptions(*app.get_subcommand("showcase"), options.showcase);

    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        failUsage("{} (try --help)", error.what());
    }
    options.courtyard.light = courtyardLightFrom(options.light);

    if (forest->parsed()) {
        const ForestFiles files = writeForest(options.forest, options.folder);
        print(files.written);
        fmt::print("about {} triangles, {} of them different\n", files.trianglesShown, files.trianglesStored);
        return 0;
    }
    if (showcase->parsed()) {
        const ShowcaseFiles files = writeShowcase(options.showcase, options.folder);
        print(files.written);
        fmt::print("{} triangles\n", files.trianglesShown);
        return 0;
    }
    const GeneratedScene scene = cornellBox->parsed() ? generateCornellBox()
                                 : cube->parsed()     ? generateCube()
                                                      : generateCourtyard(options.courtyard);
    print(writeGeneratedScene(scene, options.folder));
    fmt::print("{} triangles, {} materials\n", triangleCount(scene.mesh), scene.mesh.materials.size());
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const manylight::Error& error) {
        fmt::print(stderr, "manylight-scenes: {}\n", error.what());
        return error.exitCode();
    } catch (const std::exception& error) {
        fmt::print(stderr, "manylight-scenes: internal error: {}\n", error.what());
        return 1;
    }
}
