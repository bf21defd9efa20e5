// One capture, from scene file to files.
#pragma once

#include "apps/common/command_line.h"

#include <filesystem>

namespace manylight {

struct CaptureOptions {
    std::filesystem::path scene;
    std::vector<std::filesystem::path> outputs;  // .exr or .png
    uint32_t frameCount = 1;
    double secondsBudget = 0.0;  // 0: none
    bool sideBySide = false;
    std::vector<std::string> aovs;
    std::filesystem::path report;
    std::string dumpGraph;
    std::string dumpPass;
    bool explain = false;
    std::string device;
    TypedSettings settings;
};

/// Throws Error before any rendering if an output cannot be what it is asked to be.
void capture(const CaptureOptions& options);

}  // namespace manylight
