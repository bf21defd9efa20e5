#include "engine/gpu/tuning_file.h"

#include "engine/core/cache_folder.h"
#include "engine/core/file.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace manylight::gpu {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFormat = "manylight_tuning";
constexpr int kVersion = 1;
constexpr const char* kNotUnderstood = "tuning files not understood, the default taken";

Json toJson(const TuningKey& key) {
    return {{"device", key.device},
            {"driver", key.driver},
            {"vendor_id", key.vendorId},
            {"device_id", key.deviceId},
            {"driver_version", key.driverVersion}};
}

/// Throws Error or an exception of the JSON library.
Json entriesIn(const fs::path& file) {
    const Json json = Json::parse(readTextFile(file));
    if (json.at(kFormat) != kVersion) fail("expected \"{}\": {}", kFormat, kVersion);
    Json devices = json.at("devices");
    for (const Json& entry : devices) entry.at("key").at("device").get<std::string>();
    return devices;
}

Tuning tuningFrom(const Json& json) {
    if (!json.is_object()) fail("expected \"tuning\": {{...}}");
    Tuning tuning;
    for (const auto& item : json.items()) {
        const auto tunable =
            std::ranges::find_if(tunables(), [&](const Tunable& known) { return item.key() == known.name; });
        if (tunable == tunables().end()) fail("unknown tunable '{}'", item.key());
        const bool isNumber = item.value().is_number_unsigned();
        const uint64_t value = isNumber ? item.value().get<uint64_t>() : 0;
        if (!isNumber || std::ranges::find(tunable->values, value) == tunable->values.end())
            fail("{} is {}", item.key(), item.value().dump());
        tunable->of(tuning) = static_cast<uint32_t>(value);
    }
    return tuning;
}

}  // namespace

TuningKey tuningKey(const Device& device) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device.physicalDevice(), &properties);
    return {device.info().name, device.info().driver, properties.vendorID, properties.deviceID,
            properties.driverVersion};
}

GroupLimits groupLimits(const Device& device) {
    const VkPhysicalDeviceLimits& limits = device.limits();
    return {limits.maxComputeWorkGroupInvocations, limits.maxComputeWorkGroupSize[0], limits.maxComputeWorkGroupSize[1],
            device.subgroupSize()};
}

std::optional<fs::path> tuningFile() {
    const char* value = std::getenv("MANYLIGHT_TUNING");
    if (value != nullptr && std::strcmp(value, "off") == 0) return std::nullopt;
    if (value != nullptr && *value != '\0') return fs::path(value);
    const std::optional<fs::path> folder = cacheFolder();
    if (!folder) return std::nullopt;
    return *folder / "tuning.json";
}

std::optional<Tuning> readTuning(const fs::path& file, const TuningKey& key, Warnings& warnings) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return std::nullopt;
    try {
        for (const Json& entry : entriesIn(file))
            if (entry.at("key") == toJson(key)) return tuningFrom(entry.at("tuning"));
    } catch (const std::exception& error) {  // Error, or one of the JSON library
        warnings.add(kNotUnderstood, printable(fmt::format("{}: {}", file.string(), error.what())));
    }
    return std::nullopt;
}

void writeTuning(const fs::path& file, const TuningKey& key, const std::optional<Tuning>& tuning) {
    Json devices = Json::array();
    try {
        for (const Json& entry : entriesIn(file))
            if (entry.at("key") != toJson(key)) devices.push_back(entry);
    } catch (const std::exception&) {
        devices = Json::array();  // nothing in it that anybody could read
    }
    if (tuning) devices.push_back({{"key", toJson(key)}, {"tuning", toJson(*tuning)}});
    std::error_code ignored;
    if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
    writeTextFile(file, Json{{kFormat, kVersion}, {"devices", devices}}.dump(2) + "\n");
}

Tuning tuningOf(const Device& device, Warnings& warnings) {
    const std::optional<fs::path> file = tuningFile();
    const std::optional<Tuning> found = file ? readTuning(*file, tuningKey(device), warnings) : std::nullopt;
    if (!found || fits(*found, groupLimits(device))) return found.value_or(Tuning{});
    warnings.add(kNotUnderstood, fmt::format("{}: more than {} can run", file->string(), device.info().name));
    return {};
}

Json toJson(const Tuning& tuning) {
    Json json = Json::object();
    for (const Tunable& tunable : tunables()) json[tunable.name] = valueOf(tunable, tuning);
    return json;
}

}  // namespace manylight::gpu
