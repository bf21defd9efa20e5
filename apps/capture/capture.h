// One capture, from scene file to files.
#pragma once

#include "apps/common/command_line.h"
#include "engine/techniques/renderer.h"

#include <filesystem>

namespace manylight {

struct CaptureOptions {
    std::filesystem::path scene;
    std::vector<std::filesystem::path> outputs;  // .exr or .png
    uint32_t frameCount = 0;                     // 0: one, or as many as the time or the error take
    double secondsBudget = 0.0;                  // 0: none
    double targetError = 0.0;                    // 0: none; see Renderer::relativeStandardError()
    bool sideBySide = false;
    std::vector<std::string> aovs;
    std::filesystem::path report;
    std::string dumpGraph;
    std::string dumpPass;
    bool explain = false;
    std::string instances = "auto";
    std::optional<double> sceneTime;  // seconds into the scene's animation
    std::string animate;              // FROM:TO:RATE, see animation.h
    bool showsProgress = true;
    std::string device;
    TypedSettings settings;

    uint32_t mostFrames() const {
        const bool endsOtherwise = secondsBudget > 0.0 || targetError > 0.0;
        return frameCount > 0 ? frameCount : endsOtherwise ? 1u << 24 : 1u;
    }
};

/// Renders and writes one picture; returns its report, or nothing if it was interrupted: then nothing is written.
std::optional<Json> capturePicture(gpu::Device& device, const Scene& scene, Renderer& renderer,
                                   const CaptureOptions& options, double importSeconds);

/// Throws Error before any rendering if an output cannot be what it is asked to be.
void capture(const CaptureOptions& options);

}  // namespace manylight
