#include "apps/common/command_line.h"

#include "engine/gpu/tuning_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <new>
#include <thread>

namespace manylight {

void addStandardOptions(CLI::App& app) {
    app.set_version_flag("--version", fmt::format("{} {}", app.get_name(), MANYLIGHT_VERSION));
    app.get_formatter()->column_width(38);
}

void addSettingOptions(CLI::App& app, TypedSettings& typed, const std::vector<std::string>& except) {
    addOptions(app, settingHelps(), typed, "Rendering", except);
}

void addOptions(CLI::App& app, const std::vector<SettingHelp>& helps, TypedSettings& typed, const std::string& group,
                const std::vector<std::string>& except) {
    for (const SettingHelp& help : helps) {
        const std::string option = help.option;
        if (std::find(except.begin(), except.end(), option) != except.end()) continue;
        app.add_option_function<std::string>(
               "--" + option, [&typed, option](const std::string& value) { typed.emplace_back(option, value); },
               help.help)
            ->type_name(help.values)
            ->group(group);
    }
}

void addInstancesOption(CLI::App& app, std::string& mode) {
    app.add_option("--instances", mode, "keep meshes that are shown several times once, or repeat them")
        ->type_name("auto|flatten|share")
        ->check([](const std::string& text) {
            const bool isKnown = text == "auto" || text == "flatten" || text == "share";
            return isKnown ? std::string() : fmt::format("--instances {}: expected auto, flatten or share", text);
        });
}

InstanceMode instanceModeFrom(const std::string& mode) {
    if (mode == "flatten") return InstanceMode::Flatten;
    return mode == "share" ? InstanceMode::Share : InstanceMode::Auto;
}

void applyTyped(RenderSettings& settings, const TypedSettings& typed) {
    for (const bool presets : {true, false})
        for (const auto& [option, value] : typed)
            if ((option == kPresetOption) == presets) applySetting(settings, option, value);
}

RenderSettings resolveSettings(const Scene& scene, const TypedSettings& typed, RenderSettings settings) {
    applySettings(settings, scene.settings, scene.path.string() + ": settings");
    applyTyped(settings, typed);
    return settings;
}

int runProgram(CLI::App& app, int argc, char** argv, const std::function<void()>& program) {
    const std::string name = app.get_name();
    try {
        app.parse(argc, argv);
        program();
        return 0;
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "{}: {} (try --help)\n", name, error.what());
        return 2;
    } catch (const Error& error) {
        fmt::print(stderr, "{}: {}\n", name, error.what());
        return error.exitCode();
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "{}: out of memory\n", name);
        return 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}: internal error, please report it: {}\n", name, error.what());
        return 1;
    }
}

void printWarnings(const Warnings& warnings) {
    for (const auto& [kind, entry] : warnings.entries()) {
        std::string places;
        for (const std::string& example : entry.examples) places += (places.empty() ? " (" : ", ") + example;
        fmt::print(stderr, "warning: {} {}{}\n", entry.count, kind, places.empty() ? "" : places + ")");
    }
}

Json describeMachine(const gpu::Device& device) {
    Warnings counted;  // by who renders
    return {{"device", device.info().name},
            {"driver", device.info().driver},
            {"vulkan", fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(device.info().apiVersion),
                                   VK_API_VERSION_MINOR(device.info().apiVersion),
                                   VK_API_VERSION_PATCH(device.info().apiVersion))},
            {"subgroup_size", device.subgroupSize()},
            {"host_threads", std::thread::hardware_concurrency()},
            {"tuning", gpu::toJson(gpu::tuningOf(device, counted))},
            {"manylight", MANYLIGHT_VERSION}};
}

}  // namespace manylight
