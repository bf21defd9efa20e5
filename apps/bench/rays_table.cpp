#include "apps/bench/rays_summary.h"

#include <fmt/format.h>

#include <algorithm>

namespace manylight {
namespace {

const char* kindName(RayKind kind) { return kind == RayKind::AnyHit ? "any" : "closest"; }

double hitRate(const RaySetRun& set) { return static_cast<double>(set.hitCount) / static_cast<double>(set.rayCount); }

std::string header(const RaysOptions& options, const RaysRun& run) {
    const Json& machine = run.machine;
    std::string text = fmt::format("Rays: {}, {} triangles, camera {} with {}x{} pixels, seed {}\n", run.sceneName,
                                   run.triangleCount, options.camera, run.width, run.height, options.seed);
    text += fmt::format("  device       {}{}, Vulkan {}\n               driver {}\n",
                        machine["device"].get<std::string>(), run.softwareDevice ? " (software)" : "",
                        machine["vulkan"].get<std::string>(), machine["driver"].get<std::string>());
    text += fmt::format("  host         {} threads, Manylight {}; Embree's single-ray queries on {} threads\n",
                        machine["host_threads"].get<int>(), machine["manylight"].get<std::string>(), run.threadCount);
    text += fmt::format("  measured     {} repetitions in turns; ours from submission to fence\n", options.repetitions);
    text += fmt::format("  ours         by {}\n", run.hardwareRays ? "the device: VK_KHR_ray_query" : "shaders");
    text += fmt::format("  lights       {} {}\n", run.lightCount,
                        run.lightsAreVpls ? "VPLs that the scene's lights leave"
                                          : "random points of the surfaces: the scene's lights leave no VPLs");
    const auto [low, high] = std::minmax_element(run.calibration.begin(), run.calibration.end());
    text += fmt::format("  calibration  a C++ loop took {:.1f} to {:.1f} ms: the machine's own noise\n", *low, *high);
    text += fmt::format("  BVH          {}built in {:.3f} s; {:.1f} bytes per triangle with the geometry\n\n",
                        run.hardwareRays ? fmt::format("for the order of triangles, {} bytes of the device's own, ",
                                                       run.memory["acceleration_structure_bytes"].get<uint64_t>())
                                         : fmt::format("{} nodes, depth {}, ", run.memory["bvh_nodes"].get<uint64_t>(),
                                                       run.memory["bvh_depth"].get<uint32_t>()),
                        run.buildSeconds, run.memory["geometry_bytes_per_triangle"].get<double>());
    return text;
}

std::string rowText(const RaySetSummary& row) {
    const auto pair = [](const BestAndMedian& value, int digits) {
        return fmt::format("{:7.{}f} {:7.{}f}", value.best, digits, value.median, digits);
    };
    const RaySetRun& set = *row.set;
    return fmt::format("{:<19}{:<8}{:>8}{:>6.1f} %  {}  {}  {}  {}{:>8}{:>7}{:>7}{:>7}{:>7}\n", set.name,
                       kindName(set.kind), set.rayCount, 100.0 * hitRate(set), pair(row.embree, 2), pair(row.ours, 2),
                       pair(row.wallRatio, 3), row.cpuRatio ? pair(*row.cpuRatio, 3) : fmt::format("{:>15}", "-"),
                       row.target ? fmt::format("{:.2f}", *row.target) : "-", set.differences.hits,
                       set.differences.undecided,
                       set.kind == RayKind::AnyHit ? "-" : std::to_string(set.differences.distances),
                       set.kind == RayKind::AnyHit ? "-" : std::to_string(set.differences.triangles));
}

std::string footer(const RaysRun& run) {
    std::string text =
        "\nMrays/s by wall time; ratio = ours / Embree; each: best, median. CPU: of all threads of the process, on a\n"
        "software device only. Against Embree's robust mode: wrong = a hit for a miss or a miss for a hit; edge = "
        "the\n";
    text += fmt::format(
        "same, within {:g} of a triangle's outline or of an end of the ray; t = a closest hit whose t differs by more\n"
        "than {:g} of itself; tri = another triangle at the same t (shared edges, coincident surfaces).\n",
        kDistanceTolerance, kDistanceTolerance);
    if (const auto targets = rayTargets(run.triangleCount))
        text += fmt::format("Targets are those for scenes of about {} triangles.\n", targets->sceneSize);
    else
        text += "Targets are for scenes of about 65000 or 260000 triangles: none applies here.\n";
    return text;
}

Json toJson(const BestAndMedian& value) { return {{"best", value.best}, {"median", value.median}}; }

Json toJson(const RaySetSummary& row) {
    const RaySetRun& set = *row.set;
    return {{"set", set.name},
            {"query", kindName(set.kind)},
            {"rays", set.rayCount},
            {"hit_rate", hitRate(set)},
            {"embree_million_rays_per_second", toJson(row.embree)},
            {"million_rays_per_second", toJson(row.ours)},
            {"wall_ratio", toJson(row.wallRatio)},
            {"cpu_ratio", row.cpuRatio ? toJson(*row.cpuRatio) : Json(nullptr)},
            {"target_ratio", row.target ? Json(*row.target) : Json(nullptr)},
            {"wrong_hits", set.differences.hits},
            {"undecided_hits", set.differences.undecided},
            {"other_distances", set.differences.distances},
            {"other_triangles", set.differences.triangles},
            {"embree_wall_seconds", set.embree.wall},
            {"embree_cpu_seconds", set.embree.cpu},
            {"wall_seconds", set.ours.wall},
            {"cpu_seconds", set.ours.cpu}};
}

}  // namespace

std::string raysTable(const RaysOptions& options, const RaysRun& run) {
    std::string text = header(options, run);
    text += fmt::format("{:<19}{:<8}{:>8}{:>8}  {:^15}  {:^15}  {:^15}  {:^15}{:>8}{:>7}{:>7}{:>7}{:>7}\n", "set",
                        "query", "rays", "hit", "Embree Mrays/s", "ours Mrays/s", "ratio, wall", "ratio, CPU", "target",
                        "wrong", "edge", "t", "tri");
    for (const RaySetSummary& row : summarise(run)) text += rowText(row);
    return text + footer(run);
}

std::string raysCsv(const RaysRun& run) {
    std::string text =
        "set,query,rays,hit_rate,embree_mrays_best,embree_mrays_median,mrays_best,mrays_median,wall_ratio_best,"
        "wall_ratio_median,cpu_ratio_best,cpu_ratio_median,target_ratio,wrong_hits,undecided_hits,other_distances,"
        "other_triangles\n";
    for (const RaySetSummary& row : summarise(run)) {
        const RaySetRun& set = *row.set;
        text += fmt::format("\"{}\",{},{},{:.5f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{},{},{},{},{},{}\n",
                            set.name, kindName(set.kind), set.rayCount, hitRate(set), row.embree.best,
                            row.embree.median, row.ours.best, row.ours.median, row.wallRatio.best, row.wallRatio.median,
                            row.cpuRatio ? fmt::format("{:.4f},{:.4f}", row.cpuRatio->best, row.cpuRatio->median) : ",",
                            row.target ? fmt::format("{:.2f}", *row.target) : "", set.differences.hits,
                            set.differences.undecided, set.differences.distances, set.differences.triangles);
    }
    return text;
}

Json raysJson(const RaysOptions& options, const RaysRun& run) {
    Json sets = Json::array();
    for (const RaySetSummary& row : summarise(run)) sets.push_back(toJson(row));
    return {{"benchmark", "rays"},
            {"scene", run.sceneName},
            {"triangles", run.triangleCount},
            {"width", run.width},
            {"height", run.height},
            {"camera", options.camera},
            {"seed", options.seed},
            {"lights", run.lightCount},
            {"lights_are_vpls", run.lightsAreVpls},
            {"machine", run.machine},
            {"repetitions", options.repetitions},
            {"embree_threads", run.threadCount},
            {"bvh_build_seconds", run.buildSeconds},
            {"memory", run.memory},
            {"hardware_rays", run.hardwareRays},
            {"calibration_milliseconds", run.calibration},
            {"sets", sets}};
}

}  // namespace manylight
