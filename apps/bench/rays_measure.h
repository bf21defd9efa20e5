// The measurement of `manylight-bench rays`: the same rays by Embree and by us, in turns.
#pragma once

#include "apps/bench/rays_options.h"
#include "engine/accel/embree_reference.h"

#include <optional>
#include <vector>

namespace manylight {

/// Seconds for one set of rays, one entry a repetition.
struct RaySeconds {
    std::vector<double> wall;
    std::vector<double> cpu;  // of the whole process, all threads
};

/// Answers that differ from those of Embree's robust mode.
struct RayDifferences {
    uint64_t hits = 0;       // a hit where Embree has none, or none where it has one: wrong
    uint64_t undecided = 0;  // the same, but within kDistanceTolerance of an end of the ray or of a triangle's outline
    uint64_t distances = 0;  // closest hits whose t differ by more than kDistanceTolerance
    uint64_t triangles = 0;  // of those with the same t, another triangle: shared edges and coincident surfaces
};
inline constexpr float kDistanceTolerance = 1e-5f;  // relative

struct RaySetRun {
    std::string name;
    RayKind kind = RayKind::AnyHit;
    size_t rayCount = 0;
    size_t hitCount = 0;  // by Embree's robust mode
    RaySeconds embree;
    RaySeconds ours;
    RayDifferences differences;
};

struct RaysRun {
    std::string sceneName;
    size_t triangleCount = 0;
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t threadCount = 0;
    size_t lightCount = 0;
    bool lightsAreVpls = false;  // see BenchLights
    Json machine;
    Json memory;  // of the scene on the device; nodes, depth, bytes per triangle
    double buildSeconds = 0.0;
    bool softwareDevice = false;  // runs on this process's threads: CPU time covers it
    bool hardwareRays = false;    // ours are by VK_KHR_ray_query
    std::vector<RaySetRun> sets;
    std::vector<double> calibration;  // milliseconds: before every repetition, and after the last
};

/// Imports the scene and measures. Throws Error.
RaysRun measureRays(const RaysOptions& options);

}  // namespace manylight
