// What the user of `manylight-bench error` may choose.
#pragma once

#include "apps/bench/table_files.h"
#include "apps/common/command_line.h"

#include <filesystem>

namespace manylight {

struct ErrorOptions {
    std::filesystem::path scene;
    std::vector<std::string> modes;   // see error_mode.h; empty: kDefaultModes
    double secondsPerRun = 8.0;       // of one mode with one seed
    uint32_t seedCount = 8;           // at least 2
    double referenceSeconds = 120.0;  // to make or to refine the reference
    double referenceError = 5e-4;     // good enough: its RMSE over its mean
    std::string referenceFile;        // somebody else's reference instead
    bool flip = true;
    bool leaveOutLamps = false;  // pixels that see an emitter, or are next to one that does
    std::string device;
    TypedSettings settings;

    TableFiles files;
    std::string plot;           // file name, empty for none
    std::string pictureFolder;  // last pictures, the reference and their differences; empty for none
};

}  // namespace manylight
