// The tunings of devices in a small JSON file, as `manylight-bench tune` leaves it.
#pragma once

#include "engine/core/report.h"
#include "engine/gpu/device.h"
#include "engine/gpu/tuning.h"

#include <filesystem>
#include <optional>

namespace manylight::gpu {

/// What a tuning was measured on: another driver is another device.
struct TuningKey {
    std::string device;
    std::string driver;
    uint32_t vendorId = 0;
    uint32_t deviceId = 0;
    uint32_t driverVersion = 0;
    bool operator==(const TuningKey&) const = default;
};
TuningKey tuningKey(const Device& device);
GroupLimits groupLimits(const Device& device);

/// MANYLIGHT_TUNING=off: none; =FILE: that; otherwise tuning.json in cacheFolder(), if there is one.
std::optional<std::filesystem::path> tuningFile();

/// What `file` has of the device; empty if nothing, or if there is no such file. A file or an entry that makes no sense
/// is a warning.
std::optional<Tuning> readTuning(const std::filesystem::path& file, const TuningKey& key, Warnings& warnings);

/// Puts an entry in the place of the device's own; without a tuning there is none after that. Those of other devices
/// stay; a file that makes no sense is replaced. Makes the folder. Throws Error.
void writeTuning(const std::filesystem::path& file, const TuningKey& key, const std::optional<Tuning>& tuning);

/// The device's tuning as tuningFile() has it, the default if it has none or one that the device cannot run: a warning.
Tuning tuningOf(const Device& device, Warnings& warnings);

Json toJson(const Tuning& tuning);

}  // namespace manylight::gpu
