// What the user of `manylight-bench fps` may choose.
#pragma once

#include "apps/common/command_line.h"

#include <filesystem>

namespace manylight {

struct FpsOptions {
    std::filesystem::path scene;
    std::vector<uint32_t> vplCounts = {20, 50, 90, 200, 500, 800};  // those of the seed paper
    std::vector<uint32_t> shadowedVplCounts;                        // empty: as shadowedCounts() says
    std::vector<std::string> techniques = {"forward", "forward-prepass", "deferred"};
    std::vector<std::string> shadows = {"off", "on"};
    double secondsPerCell = 2.0;  // at least, over all rounds
    uint32_t framesPerCell = 5;   // at least, over all rounds
    uint32_t roundCount = 3;
    std::string device;
    TypedSettings settings;

    std::string csv;  // file name, "-" for standard output, empty for none
    std::string json;
    std::string text;
    std::string plot;
};

}  // namespace manylight
