// Ground, walls, floors and roofs.
#include "engine/scene/generate/courtyard_parts.h"
#include "engine/scene/generate/shapes.h"
#include "shaders/shared/constants.h"

namespace manylight::courtyard {

namespace {

enum Part : uint64_t { kGroundPart = 100, kWallPart };

/// A cell of the paving: stones of slightly different height with narrow joints.
void addStone(const Site& site, const glm::dvec2& low, const glm::dvec2& high, double height, SceneRandom& random,
              const std::array<uint32_t, 4>& materials) {
    constexpr double kJoint = 0.012;
    const double top = height + random.between(-0.006, 0.006);
    addPavingStone(site.mesh, {}, {low.x + kJoint, height - 0.04, low.y + kJoint},
                   {high.x - kJoint, top, high.y - kJoint}, 0.012, materials[random.below(4)]);
}

/// The stones of a rectangle, in courses shifted by half a stone, outside of the hole.
void addPaving(const Site& site, const glm::dvec2& half, const glm::dvec2& hole, double stone, double height,
               SceneRandom& random, const std::array<uint32_t, 4>& materials) {
    const auto columns = static_cast<uint32_t>(std::lround(2.0 * half.x / stone));
    const auto courses = static_cast<uint32_t>(std::lround(2.0 * half.y / stone));
    const glm::dvec2 size = 2.0 * half / glm::dvec2(columns, courses);
    for (uint32_t j = 0; j < courses; ++j)
        for (uint32_t i = 0; i < columns; ++i) {
            const glm::dvec2 low = -half + size * glm::dvec2(i, j);
            const glm::dvec2 center = glm::abs(low + 0.5 * size);
            if (center.x < hole.x && center.y < hole.y) continue;
            addStone(site, low, low + size, height, random, materials);
        }
}

/// A door or a shuttered window: a stone frame around two painted leaves, standing proud of the wall.
void addOpening(const Site& site, const Placement& foot, double width, double height, uint32_t paint) {
    const double half = 0.5 * width;
    const double frame = 0.16;
    const uint32_t stone = site.palette.sandstone;
    beginObject(site.mesh, "opening");
    addBox(site.mesh, foot, {-half - frame, 0, -0.1}, {-half, height, 0}, stone);
    addBox(site.mesh, foot, {half, 0, -0.1}, {half + frame, height, 0}, stone);
    addBox(site.mesh, foot, {-half - frame, height, -0.12}, {half + frame, height + frame, 0}, stone);
    for (const double left : {-half, 0.01}) {
        const double right = left + half - 0.01;
        addBox(site.mesh, foot, {left, 0, -0.05}, {right, height, 0}, paint);
        const uint32_t panels = site.detail.count(3, 1);
        const double step = height / panels;
        for (uint32_t i = 0; i < panels; ++i)
            addBox(site.mesh, foot, {left + 0.07, step * i + 0.05, -0.07}, {right - 0.07, step * (i + 1) - 0.05, -0.05},
                   paint);
    }
}

/// Bay by bay: a pilaster, a painted dado, and a door, a window or a plain field of plaster above it.
void addWallBays(const Site& site, const Side& side, double foot, double height, bool upper, SceneRandom& random) {
    for (uint32_t bay = 0; bay < side.bays; ++bay) {
        const Placement corner = side.place.at({kBay * bay, foot, 0.0});
        const uint32_t dado = site.palette.paint[random.below(5)];
        const uint32_t opening = site.palette.paint[random.below(5)];
        beginObject(site.mesh, "wall_bay");
        addBox(site.mesh, corner, {-0.22, 0, -0.12}, {0.22, height, 0}, site.palette.sandstone);
        addBox(site.mesh, corner, {0.22, 0, -0.03}, {kBay - 0.22, upper ? 0.8 : 1.25, 0}, dado);
        addBox(site.mesh, corner, {0.22, upper ? 0.8 : 1.25, -0.05}, {kBay - 0.22, upper ? 0.86 : 1.33, 0},
               site.palette.sandstone);
        if ((bay + (upper ? 1 : 0)) % 2 == 1)
            addOpening(site, corner.at({0.5 * kBay, 0, -0.03}), upper ? 1.0 : 1.3, upper ? 2.1 : 2.4, opening);
    }
}

void addJoists(const Site& site, const Side& side, double width, double top, uint32_t perBay) {
    const double step = kBay / perBay;
    beginObject(site.mesh, "joists");
    for (uint32_t i = 0; i < side.bays * perBay; ++i) {
        const double x = (i + 0.5) * step;
        addBox(site.mesh, side.place, {x - 0.07, top - 0.2, 0.2}, {x + 0.07, top, width - 0.05}, site.palette.wood);
    }
}

/// Rows of half-round tiles running down a slope from (z0, y0) at the eaves to (z1, y1).
void addTiles(const Site& site, const Side& side, const glm::dvec2& eaves, const glm::dvec2& ridge) {
    const uint32_t perBay = site.detail.count(7, 3);
    const uint32_t segments = site.detail.count(3, 2);
    const double radius = 0.47 * kBay / perBay;
    const uint32_t first = perBay;  // the mitred corners stay bare
    beginObject(site.mesh, "roof_tiles", false);
    for (uint32_t row = first; row < (side.bays - 1) * perBay; ++row) {
        const double x = (row + 0.5) * kBay / perBay;
        std::vector<uint32_t> low;
        std::vector<uint32_t> high;
        for (uint32_t i = 0; i <= segments; ++i) {
            const double angle = double{shared::kPi} * i / segments;
            const glm::dvec2 arc{-radius * std::cos(angle), radius * std::sin(angle)};
            low.push_back(addPosition(site.mesh, side.place.point({x + arc.x, eaves.y + arc.y, eaves.x})));
            high.push_back(addPosition(site.mesh, side.place.point({x + arc.x, ridge.y + arc.y, ridge.x})));
        }
        for (uint32_t i = 0; i < segments; ++i)
            addQuad(site.mesh, site.palette.roofTile, low[i], high[i], high[i + 1], low[i + 1]);
    }
}

/// A moulded string course around the court: `out` is how far it projects from the face of the arcade.
void addCornice(const Site& site, double y, double out) {
    const double face = -0.5 * kArcadeThickness;
    beginObject(site.mesh, "cornice");
    addRectangularRing(site.mesh, kCourtHalf,
                       {{face - 0.3 * out, y},
                        {face + 0.05, y},
                        {face + 0.05, y + 0.3},
                        {face - out, y + 0.3},
                        {face - out, y + 0.2},
                        {face - 0.6 * out, y + 0.12}},
                       site.palette.sandstone);
}

}  // namespace

void addGround(const Site& site) {
    SceneRandom random = site.random(kGroundPart);
    const glm::dvec2 outer = site.half(site.rows);
    beginObject(site.mesh, "foundation");
    addBox(site.mesh, {}, {-outer.x - 0.5, -0.5, -outer.y - 0.5}, {outer.x + 0.5, -0.05, outer.y + 0.5},
           site.palette.sandstone);
    beginObject(site.mesh, "gallery_base");
    addRectangularRing(site.mesh, kCourtHalf,
                       {{0.3, -0.05}, {kBay * site.rows, -0.05}, {kBay * site.rows, 0.12}, {0.3, 0.12}},
                       site.palette.sandstone);
    beginObject(site.mesh, "kerb");
    addRectangularRing(site.mesh, kCourtHalf,
                       {{-0.45, -0.05}, {0.35, -0.05}, {0.35, kGalleryFloor}, {-0.4, kGalleryFloor}, {-0.45, 0.1}},
                       site.palette.marble);

    if (!site.detail.has(0.25)) return;
    const double courtStone = kBay / site.detail.count(4, 1);
    const double galleryStone = kBay / site.detail.count(3, 1);
    beginObject(site.mesh, "court_paving", false);
    addPaving(site, kCourtHalf - 0.45, glm::dvec2(0.0), courtStone, 0.0, random, site.palette.paving);
    beginObject(site.mesh, "gallery_paving", false);
    addPaving(site, outer, kCourtHalf + 0.1, galleryStone, kGalleryFloor, random, site.palette.galleryTile);
}

void addWalls(const Site& site) {
    SceneRandom random = site.random(kWallPart);
    const glm::dvec2 outer = site.half(site.rows);
    beginObject(site.mesh, "outer_wall");
    addRectangularRing(site.mesh, outer, {{0.0, -0.05}, {0.45, -0.05}, {0.45, kUpperFloor}, {0.0, kUpperFloor}},
                       site.palette.plaster);
    beginObject(site.mesh, "upper_wall");
    addRectangularRing(site.mesh, site.half(1), {{0.0, kUpperFloor}, {0.4, kUpperFloor}, {0.4, 9.45}, {0.0, 9.45}},
                       site.palette.plaster);
    if (!site.detail.has(0.5)) return;
    for (const Side& side : sidesOf(outer)) addWallBays(site, side, kGalleryFloor, 4.3, false, random);
    for (const Side& side : sidesOf(site.half(1))) addWallBays(site, side, kUpperFloor, 3.6, true, random);
}

void addFloorsAndRoofs(const Site& site) {
    const double width = kBay * site.rows;
    const double face = -0.5 * kArcadeThickness;
    beginObject(site.mesh, "upper_floor");
    addRectangularRing(site.mesh, kCourtHalf,
                       {{face, 4.45}, {width + 0.2, 4.45}, {width + 0.2, kUpperFloor}, {face, kUpperFloor}},
                       site.palette.plaster);
    beginObject(site.mesh, "roof");
    addRectangularRing(site.mesh, kCourtHalf, {{-0.75, 8.2}, {-0.75, 8.1}, {3.5, 9.6}, {3.5, 9.78}},
                       site.palette.roofTile);
    addCornice(site, 4.45, 0.22);
    addCornice(site, kEaves - 0.3, 0.28);
    if (!site.detail.has(0.55)) return;
    const uint32_t perBay = site.detail.count(3, 2);
    for (const Side& side : sidesOf(kCourtHalf)) {
        addTiles(site, side, {-0.8, 8.19}, {3.5, 9.77});
        addJoists(site, side, kBay, 8.35, perBay);
    }
    for (uint32_t row = 0; row < site.rows; ++row)
        for (const Side& side : sidesOf(site.half(row))) addJoists(site, side, kBay, 4.45, perBay);
}

}  // namespace manylight::courtyard
