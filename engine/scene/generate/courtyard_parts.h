// What the courtyard is made of; each function adds objects to the mesh. Metres, y up.
#pragma once

#include <array>
#include <cmath>

#include "engine/scene/generate/mesh.h"
#include "engine/scene/generate/random.h"

namespace manylight::courtyard {

/// Measures that all parts agree on.
inline constexpr glm::dvec2 kCourtHalf{7.5, 6.0};  // to the axis of the innermost row of columns: x, z
inline constexpr double kBay = 3.0;                // from column to column, and from row to row
inline constexpr double kGalleryFloor = 0.15;
inline constexpr double kUpperFloor = 4.75;
inline constexpr double kEaves = 8.25;
inline constexpr double kArcadeThickness = 0.42;
inline constexpr glm::dvec3 kLanternPosition{0.0, 3.3, 0.0};
inline constexpr glm::dvec3 kCameraOrigin{-6.6, 1.7, 7.9};  // in the gallery; nothing small stands close to it

/// How finely everything is divided; 1 is the courtyard of 65,000 triangles.
struct Detail {
    double level = 1.0;

    uint32_t count(double atLevelOne, uint32_t least) const {
        return std::max(least, static_cast<uint32_t>(std::lround(atLevelOne * level)));
    }
    bool has(double fromLevel) const { return level >= fromLevel; }
};

/// Indices of the materials.
struct Palette {
    uint32_t marble, sandstone, cream, voussoirRed, voussoirPale, plaster, wood, darkWood, iron, water, roofTile;
    uint32_t trunk, fruit, rope;
    std::array<uint32_t, 4> paving, galleryTile, pottery;
    std::array<uint32_t, 5> paint, cloth;
    std::array<uint32_t, 4> leaf;
    uint32_t flower;
};
Palette addPalette(Mesh& mesh);

/// Where leaves grow: a spheroid and the area of leaves it carries, in m^2.
struct LeafCloud {
    glm::dvec3 center;
    glm::dvec3 radii;
    double leafArea;
    double flowerShare;
};

struct Site {
    Mesh& mesh;
    const Palette& palette;
    Detail detail;
    uint32_t rows;  // of columns per gallery
    uint64_t seed;
    std::vector<LeafCloud>& leafClouds;

    /// Half sizes of the ring that carries row `row`; row 0 bounds the court.
    glm::dvec2 half(uint32_t row) const { return kCourtHalf + glm::dvec2(kBay * row); }
    /// Each part draws from its own sequence, so that a change of one does not rearrange the others.
    SceneRandom random(uint64_t part) const { return SceneRandom(seed * 0x100000001b3u + part); }
};

/// One side of a ring: x runs along it from corner to corner, z points away from the court.
struct Side {
    Placement place;
    double length = 0.0;
    uint32_t bays = 0;
};
std::array<Side, 4> sidesOf(const glm::dvec2& half);

void addGround(const Site& site);
void addColumnsAndArches(const Site& site);
void addWalls(const Site& site);
void addFloorsAndRoofs(const Site& site);
void addBalustrades(const Site& site);
void addFountainAndLantern(const Site& site);
void addTrees(const Site& site);
void addFurnishings(const Site& site);

/// Adds exactly `count` leaves of two triangles, shared out over the clouds by area.
void addLeaves(const Site& site, uint64_t count);

}  // namespace manylight::courtyard
