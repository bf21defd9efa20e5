// What the programs' command lines have in common.
#pragma once

#include "engine/gpu/device.h"
#include "engine/scene/import_options.h"
#include "engine/scene/scene.h"
#include "engine/techniques/settings.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace manylight {

/// Options of the renderer as they were typed, in order.
using TypedSettings = std::vector<std::pair<std::string, std::string>>;

/// Adds --help, --version and the exit-code note.
void addStandardOptions(CLI::App& app);

/// Adds one option for every setting of the renderer, but those in `except`.
void addSettingOptions(CLI::App& app, TypedSettings& typed, const std::vector<std::string>& except = {});

/// The same for options described elsewhere.
void addOptions(CLI::App& app, const std::vector<SettingHelp>& helps, TypedSettings& typed, const std::string& group,
                const std::vector<std::string>& except = {});
/// Adds --instances, for ImportOptions.
void addInstancesOption(CLI::App& app, std::string& mode);
InstanceMode instanceModeFrom(const std::string& mode);

/// In the order they were typed, but the preset before what it presets.
void applyTyped(RenderSettings& settings, const TypedSettings& typed);
/// `settings` of the program first, then the sidecar's, then the command line's.
RenderSettings resolveSettings(const Scene& scene, const TypedSettings& typed, RenderSettings settings = {});

/// Parses, runs `program`, and turns exceptions into one line and an exit code: 0, 1 (the world's fault), 2 (usage).
int runProgram(CLI::App& app, int argc, char** argv, const std::function<void()>& program);

/// Prints the scene's warnings on standard error, one line a kind.
void printWarnings(const Warnings& warnings);

/// Where and with what a number was measured: device, driver, API version, tuning, program version, processors.
Json describeMachine(const gpu::Device& device);

}  // namespace manylight
