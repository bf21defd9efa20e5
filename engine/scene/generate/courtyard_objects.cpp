// Fountain, lantern and everything small that stands about.
#include "engine/scene/generate/courtyard_parts.h"
#include "engine/scene/generate/shapes.h"
#include "shaders/shared/constants.h"

namespace manylight::courtyard {

namespace {

enum Part : uint64_t { kFurnishingPart = 201 };

/// A planter of clay with earth in it; returns the height of the earth.
double addPot(const Site& site, const Placement& foot, double size, uint32_t material) {
    const double r = size;
    beginObject(site.mesh, "pot");
    LatheProfile profile{{0.62 * r, 0},       {0.8 * r, 0.4 * r},  {0.98 * r, 1.1 * r},  {0.98 * r, 1.25 * r},
                         {1.1 * r, 1.28 * r}, {1.1 * r, 1.45 * r}, {0.92 * r, 1.45 * r}, {0.9 * r, 1.25 * r}};
    addLathe(site.mesh, foot, profile, site.detail.count(12, 5), material);
    return 1.25 * r;
}

void addPottedBush(const Site& site, const Placement& foot, SceneRandom& random) {
    const double size = random.between(0.2, 0.32);
    const double earth = addPot(site, foot, size, site.palette.pottery[random.below(4)]);
    const double radius = size * random.between(1.3, 1.8);
    site.leafClouds.push_back({foot.point({0, earth + 0.8 * radius, 0}),
                               {radius, radius * random.between(0.9, 1.4), radius},
                               9.0 * radius * radius,
                               random.below(3) == 0 ? 0.3 : 0.0});
}

void addAmphora(const Site& site, const Placement& foot, SceneRandom& random) {
    const double s = random.between(0.8, 1.2);
    beginObject(site.mesh, "amphora");
    LatheProfile profile{{0.1, 0},     {0.14, 0.05}, {0.26, 0.3}, {0.3, 0.5},   {0.26, 0.68},
                         {0.12, 0.82}, {0.1, 0.92},  {0.15, 1.0}, {0.13, 1.01}, {0.08, 0.92}};
    for (glm::dvec2& p : profile) p *= s;
    addLathe(site.mesh, foot, profile, site.detail.count(14, 5), site.palette.pottery[random.below(4)]);
}

void addBarrel(const Site& site, const Placement& foot) {
    const uint32_t segments = site.detail.count(14, 5);
    beginObject(site.mesh, "barrel");
    addLathe(site.mesh, foot, {{0.26, 0}, {0.32, 0.25}, {0.335, 0.43}, {0.32, 0.61}, {0.26, 0.86}}, segments,
             site.palette.wood);
    if (!site.detail.has(0.65)) return;
    for (const double y : {0.16, 0.66})
        addLathe(site.mesh, foot, {{0.315, y}, {0.332, y}, {0.332, y + 0.05}, {0.315, y + 0.05}}, segments,
                 site.palette.iron);
}

void addCrate(const Site& site, const Placement& foot, double size) {
    const double h = 0.5 * size;
    beginObject(site.mesh, "crate");
    addBox(site.mesh, foot, {-h, 0, -h}, {h, size, h}, site.palette.wood);
    if (!site.detail.has(0.65)) return;
    const double batten = 0.12 * size;
    for (const double z : {-h - 0.02, h})
        for (const double y : {0.0, size - batten})
            addBox(site.mesh, foot, {-h - 0.02, y, z}, {h + 0.02, y + batten, z + 0.02}, site.palette.darkWood);
}

void addBench(const Site& site, const Placement& foot) {
    beginObject(site.mesh, "bench");
    for (const double x : {-0.6, 0.45})
        addBox(site.mesh, foot, {x, 0, -0.18}, {x + 0.15, 0.4, 0.18}, site.palette.marble);
    const uint32_t slats = site.detail.count(3, 1);
    const double depth = 0.46 / slats;
    for (uint32_t i = 0; i < slats; ++i)
        addBox(site.mesh, foot, {-0.8, 0.4, -0.23 + depth * i + 0.01}, {0.8, 0.46, -0.23 + depth * (i + 1) - 0.01},
               site.palette.wood);
}

/// A cloth that hangs in soft folds: a thin closed sheet, its lower edge free.
void addHanging(const Site& site, const Placement& top, double width, double height, uint32_t material) {
    const uint32_t columns = site.detail.count(10, 3);
    const double thickness = 0.012;
    std::vector<std::array<uint32_t, 4>> strips;  // front low, front high, back high, back low
    for (uint32_t i = 0; i <= columns; ++i) {
        const double t = static_cast<double>(i) / columns;
        const double x = width * (t - 0.5);
        const double fold = 0.05 * std::sin(6.0 * double{shared::kPi} * t);
        const auto add = [&](double y, double z) { return addPosition(site.mesh, top.point({x, y, z})); };
        strips.push_back(
            {add(-height, fold), add(0, 0.2 * fold), add(0, 0.2 * fold + thickness), add(-height, fold + thickness)});
    }
    beginObject(site.mesh, "hanging");
    for (uint32_t i = 0; i < columns; ++i)
        for (uint32_t k = 0; k < 4; ++k) {
            const uint32_t next = (k + 1) % 4;
            const auto &a = strips[i], &b = strips[i + 1];
            addTriangle(site.mesh, material, a[k], a[next], b[next]);
            addTriangle(site.mesh, material, a[k], b[next], b[k]);
        }
    const auto &a = strips.front(), &b = strips.back();
    addQuad(site.mesh, material, a[0], a[3], a[2], a[1]);
    addQuad(site.mesh, material, b[0], b[1], b[2], b[3]);
}

/// What stands in one bay of a gallery, drawn at random; `place` is the middle of the bay, z away from the court.
void furnishBay(const Site& site, const Placement& place, bool atWall, SceneRandom& random) {
    const double yaw = random.between(-0.5, 0.5);
    const Placement spot = turned(place.point({random.between(-0.7, 0.7), 0, 0}), yaw);
    if (glm::distance(spot.origin, kCameraOrigin) < 2.8) return;
    const uint32_t kind = random.below(atWall ? 7 : 5);
    if (kind == 0) addPottedBush(site, spot, random);
    if (kind == 1) addAmphora(site, spot, random);
    if (kind == 2) {
        addAmphora(site, spot, random);
        addAmphora(site, spot.at({0.65, 0, 0.1}), random);
    }
    if (kind == 3) addBarrel(site, spot);
    if (kind == 4) {
        addCrate(site, spot, 0.6);
        addCrate(site, turned(spot.point({0.05, 0.6, 0}), yaw + 0.4), 0.42);
        addBarrel(site, spot.at({0.8, 0, 0}));
    }
    if (kind >= 5) addBench(site, place.at({0, 0, 0.1}));
}

}  // namespace

void addFountainAndLantern(const Site& site) {
    const uint32_t around = site.detail.count(24, 6);
    const Palette& palette = site.palette;
    beginObject(site.mesh, "fountain");
    addLathe(site.mesh, {}, {{1.75, -0.04}, {1.75, 0.12}, {1.5, 0.12}}, around, palette.sandstone);
    addLathe(site.mesh, {{0, 0.12, 0}},
             {{1.4, 0}, {1.35, 0.08}, {1.38, 0.4}, {1.5, 0.44}, {1.5, 0.54}, {1.25, 0.54}, {1.25, 0.1}}, around,
             palette.marble);
    addLathe(site.mesh, {{0, 0.12, 0}}, {{1.25, 0.1}, {1.25, 0.42}}, around, palette.water);
    if (site.detail.has(0.25))
        addLathe(site.mesh, {{0, 0.5, 0}},
                 {{0.3, 0},
                  {0.24, 0.08},
                  {0.14, 0.2},
                  {0.12, 0.45},
                  {0.16, 0.5},
                  {0.14, 0.56},
                  {0.3, 0.62},
                  {0.6, 0.74},
                  {0.68, 0.84},
                  {0.64, 0.86},
                  {0.55, 0.78},
                  {0.25, 0.7},
                  {0.1, 0.72},
                  {0.08, 0.95},
                  {0.14, 1.02},
                  {0.12, 1.1},
                  {0.0, 1.2}},
                 around, palette.marble);

    // The lantern hangs from a rope between the galleries; only its lid is solid, the light burns below it.
    const glm::dvec3 p = kLanternPosition;
    const double ropeHeight = 7.6;
    beginObject(site.mesh, "lantern");
    addLathe(site.mesh, {p + glm::dvec3(0, 0.25, 0)}, {{0.26, 0}, {0.26, 0.03}, {0.05, 0.2}, {0.05, 0.26}},
             site.detail.count(12, 5), palette.iron);
    addBox(site.mesh, {p}, {-0.012, 0.5, -0.012}, {0.012, ropeHeight - p.y, 0.012}, palette.rope);
    addBox(site.mesh, {{0, ropeHeight, p.z}}, {-kCourtHalf.x, 0, -0.015}, {kCourtHalf.x, 0.03, 0.015}, palette.rope);
}

void addFurnishings(const Site& site) {
    if (!site.detail.has(0.45)) return;
    SceneRandom random = site.random(kFurnishingPart);
    for (uint32_t row = 0; row < site.rows; ++row) {
        const bool atWall = row + 1 == site.rows;
        for (const Side& side : sidesOf(site.half(row)))
            for (uint32_t bay = 0; bay < side.bays; ++bay)
                furnishBay(site, side.place.at({kBay * (bay + 0.5), kGalleryFloor, atWall ? kBay - 0.6 : 0.5 * kBay}),
                           atWall, random);
    }
    // Pots stand at the feet of the court's columns, cloths hang over the rail above.
    for (const Side& side : sidesOf(kCourtHalf))
        for (uint32_t bay = 0; bay < side.bays; ++bay) {
            const bool hasCloth = random.below(3) == 0;
            const uint32_t cloth = site.palette.cloth[random.below(5)];
            if (bay > 0) addPottedBush(site, side.place.at({kBay * bay, 0, -0.8}), random);
            if (hasCloth)
                addHanging(site, side.place.at({kBay * (bay + 0.5), kUpperFloor + 0.94, -0.32}), 1.5,
                           random.between(1.0, 1.5), cloth);
        }
}

void addBalustrades(const Site& site) {
    const uint32_t perBay = site.detail.count(7, 1);
    const uint32_t around = site.detail.count(7, 4);
    for (const Side& side : sidesOf(kCourtHalf)) {
        beginObject(site.mesh, "balustrade");
        const Placement rail = side.place.at({0, kUpperFloor, 0});
        addBox(site.mesh, rail, {0, 0.8, -0.11}, {side.length, 0.9, 0.11}, site.palette.sandstone);
        if (!site.detail.has(0.6)) continue;
        for (uint32_t bay = 0; bay < side.bays; ++bay)
            for (uint32_t i = 1; i <= perBay; ++i)
                addLathe(site.mesh, rail.at({kBay * (bay + i / (perBay + 1.0)), 0, 0}),
                         {{0.07, 0}, {0.05, 0.1}, {0.085, 0.3}, {0.04, 0.62}, {0.07, 0.8}}, around,
                         site.palette.marble);
    }
}

}  // namespace manylight::courtyard
