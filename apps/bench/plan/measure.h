// The measurement of `manylight-bench plan`: a scene as planned, with each decision undone, and with nothing left out.
#pragma once

#include "apps/bench/plan/options.h"
#include "engine/core/report.h"
#include "engine/core/statistics.h"
#include "engine/techniques/renderer.h"

#include <optional>

namespace manylight {

/// How far a variant's picture is from the planned one.
struct PictureDifference {
    bool sameBytes = false;
    double relative = 0.0;  // mean absolute difference over the mean radiance
};

/// A second renderer of the same: what it differs by is noise.
inline constexpr const char* kPlannedAgain = "as planned, again";

struct PlanVariant {
    std::string name;                     // "as planned", kPlannedAgain, "--plan off", or the decision that is undone
    std::string reason;                   // of that decision
    std::vector<double> gpuMilliseconds;  // one entry a frame
    std::vector<std::pair<std::string, std::vector<double>>> passes;  // the same for every pass
    uint64_t deviceBytes = 0;  // all that the renderer allocates on the device and for it on the host
    size_t pipelines = 0;
    // Pipelines and passes that either has and the other, as planned, has not.
    size_t pipelinesUnlikePlanned = 0;
    size_t passesUnlikePlanned = 0;
    double startSeconds = 0.0;  // upload, BVH, pipelines and the first frame, with the caches that a first start leaves
    PictureDifference difference;
};

struct PlanScene {
    std::string name;
    std::string file;
    size_t triangles = 0;
    RenderSettings settings;            // resolved
    std::vector<PlanVariant> variants;  // the planned one first, --plan off last
};

struct PlanRun {
    Json machine;
    std::vector<PlanScene> scenes;    // those that were measured to their end
    std::vector<double> calibration;  // milliseconds, before every scene and after the last
    bool isInterrupted = false;
};

/// The same pipelines, passes and bytes of memory as planned, and the same picture: whatever the times say, no work is
/// added.
bool isSameWork(const PlanVariant& variant, const PlanVariant& planned);

/// Imports and measures every scene. Throws Error.
PlanRun measurePlans(const PlanOptions& options);

/// The largest difference that arithmetic explains: a shader from which something is left out may be compiled to
/// another order of the same operations. Deferred shading and the path tracer of diffuse scenes must be the same to the
/// byte.
inline constexpr double kPlanTolerance = 1e-5;

}  // namespace manylight
