#include "engine/scene/generate/courtyard.h"

#include <fmt/format.h>

#include "engine/core/error.h"
#include "engine/scene/generate/courtyard_parts.h"

namespace manylight {

namespace {

using namespace courtyard;

constexpr double kLeafShare = 0.18;  // of all triangles, at least
constexpr double kCoarsestLevel = 0.2;
constexpr double kFinestLevel = 64.0;

/// Everything but the leaves; notes where they grow.
void buildWithoutLeaves(const Site& site) {
    addGround(site);
    addColumnsAndArches(site);
    addWalls(site);
    addFloorsAndRoofs(site);
    addBalustrades(site);
    addFountainAndLantern(site);
    addTrees(site);
    addFurnishings(site);
}

size_t trianglesAt(const CourtyardParameters& parameters, double level) {
    Mesh mesh;
    const Palette palette = addPalette(mesh);
    std::vector<LeafCloud> leafClouds;
    buildWithoutLeaves({mesh, palette, {level}, parameters.depth, parameters.seed, leafClouds});
    return triangleCount(mesh);
}

/// The finest level that leaves room for the leaves. Counts grow with the level, nearly as its square.
double fitLevel(const CourtyardParameters& parameters) {
    const double room = (1.0 - kLeafShare) * parameters.triangleTarget;
    const auto fits = [&](double level) { return static_cast<double>(trianglesAt(parameters, level)) <= room; };

    double low = std::max(kCoarsestLevel, std::sqrt(parameters.triangleTarget / 65'000.0) * 0.8);
    while (low > kCoarsestLevel && !fits(low)) low = std::max(kCoarsestLevel, low / 1.25);
    double high = low * 1.25;
    while (high < kFinestLevel && fits(high)) {
        low = high;
        high *= 1.25;
    }
    for (int step = 0; step < 6; ++step) {
        const double middle = 0.5 * (low + high);
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

void checkParameters(const CourtyardParameters& parameters) {
    if (parameters.depth < 1 || parameters.depth > 6)
        failUsage("courtyard: depth {} is out of range, expected 1 to 6", parameters.depth);
    if (parameters.triangleTarget > 20'000'000)
        failUsage("courtyard: {} triangles are too many, expected at most 20000000", parameters.triangleTarget);
    const size_t least = trianglesAt(parameters, kCoarsestLevel);
    if (least > parameters.triangleTarget)
        failUsage("courtyard: {} triangles are too few, depth {} needs at least {}", parameters.triangleTarget,
                  parameters.depth, least);
}

Json lightsOf(CourtyardLight light) {
    switch (light) {
        case CourtyardLight::Point:
            return Json::array({{{"type", "point"},
                                 {"name", "lantern"},
                                 {"position", toJson(kLanternPosition)},
                                 {"intensity", {90, 71, 48}}}});
        case CourtyardLight::Sun:
            return Json::array({{{"type", "directional"},
                                 {"name", "sun"},
                                 {"direction", {0.45, -1.0, -0.35}},
                                 {"irradiance", {9, 8, 6.6}}}});
        case CourtyardLight::Sky:
            return Json::array({{{"type", "constant"}, {"name", "sky"}, {"radiance", {1.6, 2.0, 2.6}}}});
        case CourtyardLight::Area:
            return Json::array({{{"type", "rect_area"},
                                 {"name", "awning"},
                                 {"center", {0, 7.2, 0}},
                                 {"u", {2.0, 0, 0}},
                                 {"v", {0, 0, 1.5}},
                                 {"radiance", {20, 17.5, 14}}}});
    }
    return Json::array();
}

}  // namespace

CourtyardLight courtyardLightFrom(std::string_view name) {
    if (name == "point") return CourtyardLight::Point;
    if (name == "sun") return CourtyardLight::Sun;
    if (name == "sky") return CourtyardLight::Sky;
    if (name == "area") return CourtyardLight::Area;
    failUsage("unknown light \"{}\", expected point, sun, sky or area", name);
}

GeneratedScene generateCourtyard(const CourtyardParameters& parameters) {
    checkParameters(parameters);
    GeneratedScene scene;
    scene.name = "courtyard";
    scene.comments = {
        "An arcaded courtyard, in metres, made by manylight-scenes.",
        fmt::format("triangles {}, depth {}, seed {}", parameters.triangleTarget, parameters.depth, parameters.seed)};

    Mesh& mesh = scene.mesh;
    const Palette palette = addPalette(mesh);
    std::vector<LeafCloud> leafClouds;
    const Site site{mesh, palette, {fitLevel(parameters)}, parameters.depth, parameters.seed, leafClouds};
    buildWithoutLeaves(site);
    addLeaves(site, (parameters.triangleTarget - triangleCount(mesh)) / 2);

    scene.sidecar["camera"] = {{"origin", toJson(kCameraOrigin)},
                               {"target", {4.5, 2.2, 1.0}},
                               {"up", {0, 1, 0}},
                               {"fov_y_deg", 64},
                               {"width", 512},
                               {"height", 384}};
    scene.sidecar["lights"] = lightsOf(parameters.light);
    scene.sidecar["max_depth"] = -1;
    return scene;
}

}  // namespace manylight
