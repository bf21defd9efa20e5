// What `manylight-bench plan` is asked for.
#pragma once

#include "apps/bench/table_files.h"
#include "apps/common/command_line.h"

#include <filesystem>
#include <string>
#include <vector>

namespace manylight {

struct PlanOptions {
    std::vector<std::filesystem::path> scenes;
    std::string instances = "auto";
    std::vector<std::string> decisions;  // that are undone, one at a time; empty: all
    uint32_t frames = 12;                // of every variant, in turns
    bool wantsAllOutputs = false;        // variance, light cut off, displayed picture: asked of every variant
    std::string device;
    TypedSettings settings;
    TableFiles files;
};

}  // namespace manylight
