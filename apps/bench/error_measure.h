// Runs every mode with several seeds and keeps pictures after 1, 2, 4, ... frames.
#pragma once

#include "apps/bench/error_mode.h"
#include "apps/bench/error_reference.h"
#include "engine/metrics/image_region.h"

namespace manylight {

/// After so many frames, one entry a seed.
struct Checkpoint {
    uint32_t frames = 0;
    std::vector<double> seconds;
    std::vector<Image> images;
};

struct ModeRun {
    ErrorMode mode;
    std::vector<Checkpoint> checkpoints;
    std::vector<double> frameSeconds;  // of every frame but the first of each seed
    double warmUpSeconds = 0.0;        // the very first frame: the driver compiles
    /// With --clamp bound: mean radiance that the bound took in as many frames as the last checkpoint's, one entry a
    /// seed.
    std::vector<double> cutOff;
};

struct ErrorRun {
    std::string sceneName;
    size_t triangleCount = 0;
    Json machine;
    RenderSettings settings;  // resolved, of the first mode
    double importSeconds = 0.0;
    double bvhSeconds = 0.0;
    double uploadSeconds = 0.0;
    Reference reference;
    std::optional<Mask> mask;  // what is compared, if not every pixel
    std::vector<ModeRun> modes;
    bool isInterrupted = false;  // seeds that were not complete are left out
    Warnings warnings;
};

ErrorRun measureError(const ErrorOptions& options);

}  // namespace manylight
