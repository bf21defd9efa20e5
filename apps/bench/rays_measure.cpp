#include "apps/bench/rays_measure.h"

#include "apps/bench/calibration.h"
#include "apps/bench/ray_bench_sets.h"
#include "apps/common/command_line.h"
#include "engine/core/progress.h"
#include "engine/scene/import.h"
#include "engine/techniques/ray_caster.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <thread>

namespace manylight {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// CPU time of all threads of the process: steadier than wall time where other programs run.
double processSeconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void timeEmbree(const EmbreeReference& embree, const BenchRays& set, uint32_t threadCount, RaySeconds& seconds) {
    const double cpuStart = processSeconds();
    const double millionPerSecond = embree.millionRaysPerSecond(set.rays, set.kind, threadCount);
    seconds.cpu.push_back(processSeconds() - cpuStart);
    seconds.wall.push_back(1e-6 * static_cast<double>(set.rays.size()) / millionPerSecond);
}

/// Wall time is from submission to fence.
void timeOurs(RayCaster& caster, RayKind kind, RaySeconds& seconds) {
    const double cpuStart = processSeconds();
    const Execution execution = caster.trace(kind);
    seconds.cpu.push_back(processSeconds() - cpuStart);
    seconds.wall.push_back(1e-3 * execution.wallMilliseconds);
}

/// Does the ray pass so near an end of its interval or the outline of a triangle that float rounding decides? In
/// double.
bool isUndecided(const Scene& scene, const shared::RayQuery& ray) {
    constexpr double kTolerance = double{kDistanceTolerance};
    const glm::dvec3 direction = ray.direction;
    for (const Triangle& triangle : scene.triangles) {
        const glm::dvec3 a = glm::dvec3(scene.vertices[triangle.vertex[0]].position) - glm::dvec3(ray.origin);
        const glm::dvec3 b = glm::dvec3(scene.vertices[triangle.vertex[1]].position) - glm::dvec3(ray.origin);
        const glm::dvec3 c = glm::dvec3(scene.vertices[triangle.vertex[2]].position) - glm::dvec3(ray.origin);
        const double u = glm::dot(direction, glm::cross(c, b));
        const double v = glm::dot(direction, glm::cross(a, c));
        const double w = glm::dot(direction, glm::cross(b, a));
        const double volume = u + v + w;
        if (volume == 0.0) continue;
        const double innermost = std::min({u / volume, v / volume, w / volume});
        if (innermost < -kTolerance) continue;
        const double t = glm::dot(a, glm::cross(b - a, c - a)) / glm::dot(direction, glm::cross(b - a, c - a));
        const bool isNearEnd = std::abs(t) < kTolerance || std::abs(t / double{ray.tMax} - 1.0) < kTolerance;
        if (isNearEnd || (innermost < kTolerance && t > 0.0 && t < double{ray.tMax})) return true;
    }
    return false;
}

void countDifferentHit(const Scene& scene, const shared::RayQuery& ray, RayDifferences& differences) {
    ++(isUndecided(scene, ray) ? differences.undecided : differences.hits);
}

void checkAnyHits(const Scene& scene, const EmbreeReference& embree, const BenchRays& set,
                  const std::vector<uint32_t>& flags, RaySetRun& run) {
    for (size_t i = 0; i < set.rays.size(); ++i) {
        const bool expected = embree.occluded(set.rays[i]);
        run.hitCount += expected ? 1 : 0;
        if ((flags[i] != 0) != expected) countDifferentHit(scene, set.rays[i], run.differences);
    }
}

void checkClosestHits(const Scene& scene, const EmbreeReference& embree, const BenchRays& set,
                      const std::vector<shared::RayHit>& hits, const TriangleNumbers& numbers, RaySetRun& run) {
    for (size_t i = 0; i < set.rays.size(); ++i) {
        const std::optional<ClosestHit> expected = embree.closest(set.rays[i]);
        const bool isHit = hits[i].triangle != shared::kNoHit;
        run.hitCount += expected ? 1 : 0;
        if (isHit != expected.has_value()) {
            countDifferentHit(scene, set.rays[i], run.differences);
        } else if (isHit && std::abs(hits[i].t - expected->t) > kDistanceTolerance * expected->t) {
            ++run.differences.distances;
        } else if (isHit && numbers.flattenedTriangle(hits[i].triangle) != expected->triangle) {
            ++run.differences.triangles;
        }
    }
}

/// Traces once without timing, which compiles the pipeline and warms the caches, and compares the answers.
RaySetRun checkSet(const Scene& scene, RayCaster& caster, const EmbreeReference& robust, const BenchRays& set) {
    RaySetRun run;
    run.name = set.name;
    run.kind = set.kind;
    run.rayCount = set.rays.size();
    caster.load(set.rays);
    caster.trace(set.kind);
    if (set.kind == RayKind::AnyHit)
        checkAnyHits(scene, robust, set, caster.occludedFlags(), run);
    else
        checkClosestHits(scene, robust, set, caster.hits(), caster.gpuScene().numbers, run);
    return run;
}

void checkSize(const gpu::Device& device, glm::uvec2 size) {
    const uint64_t mostRays = device.limits().maxStorageBufferRange / sizeof(shared::RayQuery);
    if (uint64_t{size.x} * size.y > mostRays)
        fail("--size {}x{}: device {} holds at most {} rays in one buffer", size.x, size.y, device.info().name,
             mostRays);
}

}  // namespace

RaysRun measureRays(const RaysOptions& options) {
    const Scene loaded = importScene(options.scene, {.instances = instanceModeFrom(options.instances)});
    printWarnings(loaded.warnings);
    const Scene scene = flattened(loaded);
    RenderSettings settings;
    applySetting(settings, "size", options.size);
    applySetting(settings, "rays", options.rays);
    const glm::uvec2 size{settings.width, settings.height};
    if (options.camera >= scene.cameras.size())
        failUsage("--camera {}: the scene has {} camera(s), counted from 0", options.camera, scene.cameras.size());

    gpu::Device device({.select = options.device});
    checkSize(device, size);
    RaysRun run{.sceneName = scene.name,
                .triangleCount = scene.triangles.size(),
                .width = size.x,
                .height = size.y,
                .threadCount =
                    options.threadCount > 0 ? options.threadCount : std::max(1u, std::thread::hardware_concurrency()),
                .machine = describeMachine(device),
                .memory = {},
                .softwareDevice = device.info().isSoftware(),
                .hardwareRays = false,
                .sets = {},
                .calibration = {}};
    const auto start = Clock::now();
    const Bvh bvh = buildBvh(loaded);
    run.buildSeconds = secondsSince(start);
    RayCaster caster(device, loaded, bvh, settings.rays);
    run.hardwareRays = caster.plan().hardwareRays;
    run.memory = caster.gpuScene().report();

    const BenchLights lights = makeBenchLights(device, scene, options.seed);
    const std::vector<BenchRays> sets =
        makeBenchRays(scene, scene.cameras[options.camera], size, lights.points, options.seed);
    run.lightCount = lights.points.size();
    run.lightsAreVpls = lights.areVpls;
    Progress progress("measuring", sets.size() * (options.repetitions + 1));
    {
        const EmbreeReference robust(scene, true);
        for (const BenchRays& set : sets) {
            run.sets.push_back(checkSet(scene, caster, robust, set));
            progress.advance();
        }
    }
    const EmbreeReference embree(scene);
    for (uint32_t repetition = 0; repetition < options.repetitions; ++repetition) {
        run.calibration.push_back(calibrationMilliseconds());
        for (size_t i = 0; i < sets.size(); ++i) {
            caster.load(sets[i].rays);
            timeEmbree(embree, sets[i], run.threadCount, run.sets[i].embree);
            timeOurs(caster, sets[i].kind, run.sets[i].ours);
            progress.advance();
        }
    }
    run.calibration.push_back(calibrationMilliseconds());
    return run;
}

}  // namespace manylight
