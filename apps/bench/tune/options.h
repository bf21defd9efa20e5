// What `manylight-bench tune` is asked for.
#pragma once

#include "apps/bench/table_files.h"

#include <filesystem>
#include <string>
#include <vector>

namespace manylight {

struct TuneOptions {
    std::vector<std::filesystem::path> scenes;  // none: the Cornell box and the courtyard
    std::vector<std::string> tunables;          // that are measured; empty: all
    uint32_t turns = 9;                         // in each of which every candidate renders a frame
    std::string size = "256x192";
    std::string output;  // of the tuning; empty: the file that programs read
    std::string device;
    TableFiles files;
};

}  // namespace manylight
