// Columns and the striped round arches that they carry.
#include "engine/scene/generate/courtyard_parts.h"
#include "engine/scene/generate/shapes.h"
#include "shaders/shared/constants.h"

namespace manylight::courtyard {

namespace {

/// One order of columns and arches: all heights above the foot of the column.
struct ArcadeStorey {
    double foot;
    double springing;  // where the arch begins, the top of the column
    double top;
    double columnRadius;
};
constexpr ArcadeStorey kGround{kGalleryFloor, 2.7, 4.45 - kGalleryFloor, 0.2};
constexpr ArcadeStorey kUpper{kUpperFloor, 1.85, kEaves - kUpperFloor, 0.15};

constexpr double kArchRadius = 1.2;  // of the opening
constexpr double kSlabInset = 0.06;  // the wall keeps this far behind the voussoirs
constexpr double kVoussoirHeight = 0.34;
constexpr double kVoussoirProjection = 0.035;

/// Attic base, shaft with entasis and a bell-shaped capital; fewer mouldings where detail is low.
LatheProfile columnProfile(double radius, double height, const Detail& detail) {
    const double r = radius;
    const double h = height - 0.1;
    if (!detail.has(0.5)) return {{1.15 * r, 0.0}, {0.84 * r, h - 0.3}, {1.4 * r, h + 0.1}};

    LatheProfile profile{{1.36 * r, 0.1},  {1.42 * r, 0.15}, {1.34 * r, 0.2},
                         {1.14 * r, 0.23}, {1.24 * r, 0.28}, {1.02 * r, 0.32}};
    const uint32_t drums = detail.count(3, 2);
    const double shaftTop = h - 0.42;
    for (uint32_t i = 1; i <= drums; ++i) {
        const double t = static_cast<double>(i) / drums;
        profile.push_back({r * (1.02 - 0.18 * t * t), 0.32 + (shaftTop - 0.32) * t});
    }
    const std::array<glm::dvec2, 5> capital{{{0.98, 0.02}, {0.98, 0.06}, {0.86, 0.09}, {0.95, 0.24}, {1.42, 0.42}}};
    for (const glm::dvec2& p : capital) profile.push_back({p.x * r, shaftTop + p.y});
    return profile;
}

void addColumn(const Site& site, const Placement& foot, const ArcadeStorey& storey) {
    const double r = storey.columnRadius;
    const double height = storey.springing;
    addLathe(site.mesh, foot, columnProfile(r, height, site.detail), site.detail.count(12, 5), site.palette.marble);
    if (!site.detail.has(0.5)) return;
    const double plinth = 1.5 * r;
    const double abacus = 1.6 * r;
    addBox(site.mesh, foot, {-plinth, 0, -plinth}, {plinth, 0.1, plinth}, site.palette.sandstone);
    addBox(site.mesh, foot, {-abacus, height - 0.1, -abacus}, {abacus, height, abacus}, site.palette.sandstone);
}

/// The wall above the columns: its lower edge follows the arches.
void addSpandrels(const Site& site, const Side& side, const ArcadeStorey& storey) {
    const uint32_t segments = site.detail.count(10, 2);
    const double radius = kArchRadius + kSlabInset;
    std::vector<glm::dvec2> lower{{0.0, storey.springing}};
    for (uint32_t bay = 0; bay < side.bays; ++bay)
        for (uint32_t i = 0; i <= segments; ++i) {
            const double angle = double{shared::kPi} * i / segments;
            lower.push_back(
                {kBay * (bay + 0.5) - radius * std::cos(angle), storey.springing + radius * std::sin(angle)});
        }
    lower.push_back({side.length, storey.springing});
    std::vector<glm::dvec2> upper;
    for (const glm::dvec2& p : lower) upper.push_back({p.x, storey.top});
    addSlab(site.mesh, side.place.at({0.0, storey.foot, -0.5 * kArcadeThickness}), lower, upper, kArcadeThickness,
            site.palette.cream);
}

/// Wedges of two colours in turn, the red one at the keystone.
void addVoussoirs(const Site& site, const Placement& center) {
    const uint32_t count = site.detail.count(5, 2) * 2 + 1;
    const uint32_t cuts = site.detail.has(2.0) ? site.detail.count(0.8, 1) : 1;
    const double z = 0.5 * kArcadeThickness + kVoussoirProjection;
    for (uint32_t i = 0; i < count; ++i) {
        std::vector<glm::dvec2> inner;
        std::vector<glm::dvec2> outer;
        for (uint32_t k = 0; k <= cuts; ++k) {
            const double angle = double{shared::kPi} * (i + static_cast<double>(k) / cuts) / count;
            const glm::dvec2 spoke{-std::cos(angle), std::sin(angle)};
            inner.push_back(spoke * kArchRadius);
            outer.push_back(spoke * (kArchRadius + kVoussoirHeight));
        }
        const bool red = (i + count / 2) % 2 == 0;
        addSlab(site.mesh, center.at({0, 0, -z}), inner, outer, 2.0 * z,
                red ? site.palette.voussoirRed : site.palette.voussoirPale);
    }
}

void addCornerPiers(const Site& site, const glm::dvec2& half, const ArcadeStorey& storey) {
    const double side = 0.5 * kArcadeThickness + 0.03;
    for (const double x : {-half.x, half.x})
        for (const double z : {-half.y, half.y}) {
            beginObject(site.mesh, "corner_pier");
            addBox(site.mesh, {{x, storey.foot, z}}, {-side, storey.springing, -side}, {side, storey.top, side},
                   site.palette.cream);
        }
}

void addArcadeRing(const Site& site, const glm::dvec2& half, const ArcadeStorey& storey) {
    for (const Side& side : sidesOf(half)) {
        beginObject(site.mesh, "arcade_wall");
        addSpandrels(site, side, storey);
        for (uint32_t bay = 0; bay < side.bays; ++bay) {
            beginObject(site.mesh, "column");
            addColumn(site, side.place.at({kBay * bay, storey.foot, 0.0}), storey);
            if (!site.detail.has(0.4)) continue;
            beginObject(site.mesh, "arch");
            addVoussoirs(site, side.place.at({kBay * (bay + 0.5), storey.foot + storey.springing, 0.0}));
        }
    }
    addCornerPiers(site, half, storey);
}

}  // namespace

std::array<Side, 4> sidesOf(const glm::dvec2& half) {
    const auto baysAlong = [](double length) { return static_cast<uint32_t>(std::lround(length / kBay)); };
    const glm::dvec2 length = 2.0 * half;
    const uint32_t baysX = baysAlong(length.x);
    const uint32_t baysZ = baysAlong(length.y);
    return {{{{{-half.x, 0, half.y}, 1, 0}, length.x, baysX},
             {{{half.x, 0, half.y}, 0, 1}, length.y, baysZ},
             {{{half.x, 0, -half.y}, -1, 0}, length.x, baysX},
             {{{-half.x, 0, -half.y}, 0, -1}, length.y, baysZ}}};
}

void addColumnsAndArches(const Site& site) {
    for (uint32_t row = 0; row < site.rows; ++row) addArcadeRing(site, site.half(row), kGround);
    addArcadeRing(site, site.half(0), kUpper);
}

}  // namespace manylight::courtyard
