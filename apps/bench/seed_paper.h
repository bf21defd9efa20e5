// Figures of the paper that Manylight grew out of, for ratios beside ours.
#pragma once

#include <array>
#include <cstdint>

namespace manylight {

inline constexpr const char* kSeedPaper = "KhemlicheBabahenini";  // key in docs/references.bib
inline constexpr const char* kSeedPaperMachine = "GeForce GT 635, scene and resolution not stated";

struct SeedPaperRow {
    uint32_t vplCount;
    double forwardFps;
    double deferredFps;
};

/// Its Table 1: frames per second without shadows of the VPLs.
inline constexpr std::array<SeedPaperRow, 6> kSeedPaperTable = {{{20, 38.09, 40.16},
                                                                 {50, 17.65, 39.45},
                                                                 {90, 9.62, 30.01},
                                                                 {200, 4.51, 19.55},
                                                                 {500, 1.81, 9.87},
                                                                 {800, 1.11, 6.70}}};

}  // namespace manylight
