// What the user of `manylight-bench rays` may choose.
#pragma once

#include "apps/bench/table_files.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace manylight {

struct RaysOptions {
    std::filesystem::path scene;
    std::string size = "512x384";  // primary rays
    uint32_t camera = 0;
    std::string instances = "auto";
    std::string rays = "auto";
    uint32_t repetitions = 15;
    uint32_t threadCount = 0;  // for Embree; 0: as many as the host has
    uint32_t seed = 0;
    std::string device;
    TableFiles files;
};

}  // namespace manylight
