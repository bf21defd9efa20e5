#include "apps/bench/rays_summary.h"

#include "engine/core/statistics.h"

#include <algorithm>

namespace manylight {
namespace {

double best(const std::vector<double>& seconds) { return *std::min_element(seconds.begin(), seconds.end()); }

BestAndMedian millionsPerSecond(size_t rayCount, const std::vector<double>& seconds) {
    const double millions = 1e-6 * static_cast<double>(rayCount);
    return {millions / best(seconds), millions / median(seconds)};
}

BestAndMedian ratio(const std::vector<double>& embree, const std::vector<double>& ours) {
    return {best(embree) / best(ours), median(embree) / median(ours)};
}

}  // namespace

std::optional<RayTargets> rayTargets(size_t triangleCount) {
    // The bounds are half an order of magnitude around each size.
    if (triangleCount >= 32'000 && triangleCount < 130'000) return RayTargets{65'000, 0.60, 0.55, 0.55};
    if (triangleCount >= 130'000 && triangleCount < 520'000) return RayTargets{260'000, 0.50, 0.45, 0.45};
    return std::nullopt;
}

std::vector<RaySetSummary> summarise(const RaysRun& run) {
    const std::optional<RayTargets> targets = rayTargets(run.triangleCount);
    std::vector<RaySetSummary> summaries;
    for (const RaySetRun& set : run.sets) {
        RaySetSummary summary;
        summary.set = &set;
        summary.embree = millionsPerSecond(set.rayCount, set.embree.wall);
        summary.ours = millionsPerSecond(set.rayCount, set.ours.wall);
        summary.wallRatio = ratio(set.embree.wall, set.ours.wall);
        if (run.softwareDevice) summary.cpuRatio = ratio(set.embree.cpu, set.ours.cpu);
        if (targets && set.name == "shadow, coherent") summary.target = targets->coherent;
        if (targets && set.name == "shadow, incoherent") summary.target = targets->incoherent;
        if (targets && set.name == "bounce" && set.kind == RayKind::ClosestHit) summary.target = targets->bounce;
        summaries.push_back(summary);
    }
    return summaries;
}

uint64_t wrongHits(const RaysRun& run) {
    uint64_t count = 0;
    for (const RaySetRun& set : run.sets) count += set.differences.hits;
    return count;
}

}  // namespace manylight
