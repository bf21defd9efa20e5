// What the user of `manylight-bench fps` may choose.
#pragma once

#include "apps/bench/table_files.h"
#include "apps/common/command_line.h"

#include <filesystem>

namespace manylight {

struct FpsOptions {
    std::filesystem::path scene;
    std::vector<uint32_t> vplCounts = {20, 50, 90, 200, 500, 800};  // those of the seed paper
    std::vector<uint32_t> shadowedVplCounts;                        // empty: as shadowedCounts() says
    std::vector<std::string> techniques = {"forward", "forward-prepass", "deferred", "interleaved", "filtered"};
    std::vector<std::string> shadows = {"off", "on"};
    double secondsPerCell = 2.0;  // at least, over all rounds
    uint32_t framesPerCell = 5;   // at least, over all rounds
    uint32_t roundCount = 3;
    std::string device;
    TypedSettings settings;

    TableFiles files;
    std::string plot;  // file name, empty for none
};

}  // namespace manylight
