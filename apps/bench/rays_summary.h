// From the samples of `manylight-bench rays` to its tables.
#pragma once

#include "apps/bench/rays_measure.h"

namespace manylight {

struct BestAndMedian {
    double best = 0.0;
    double median = 0.0;
};

struct RaySetSummary {
    const RaySetRun* set = nullptr;
    BestAndMedian embree;  // millions of rays per second of wall time
    BestAndMedian ours;
    BestAndMedian wallRatio;                // ours over Embree's
    std::optional<BestAndMedian> cpuRatio;  // the same per second of CPU time; on a software device only
    std::optional<double> target;           // for the ratio
};

/// A scene of `triangleCount` triangles and the size whose targets apply to it; none if it is far from both.
struct RayTargets {
    size_t sceneSize = 0;
    double coherent = 0.0;
    double incoherent = 0.0;
    double bounce = 0.0;  // closest hit
};
std::optional<RayTargets> rayTargets(size_t triangleCount);

std::vector<RaySetSummary> summarise(const RaysRun& run);

/// Rays that hit where Embree's robust mode misses or the other way round, over all sets.
uint64_t wrongHits(const RaysRun& run);

std::string raysTable(const RaysOptions& options, const RaysRun& run);
std::string raysCsv(const RaysRun& run);
Json raysJson(const RaysOptions& options, const RaysRun& run);

}  // namespace manylight
