// Orange trees in the court and ivy in the arches: they carry most of the leaves.
#include "engine/scene/generate/courtyard_parts.h"
#include "engine/scene/generate/shapes.h"
#include "shaders/shared/constants.h"

namespace manylight::courtyard {

namespace {

enum Part : uint64_t { kTreePart = 200 };

void addFruit(const Site& site, const LeafCloud& crown, SceneRandom& random) {
    for (uint32_t i = 0; i < 14; ++i) {
        const double around = 2.0 * double{shared::kPi} * random.unit();
        const double up = random.between(-0.6, 0.6);
        const double out = std::sqrt(1.0 - up * up);
        const glm::dvec3 direction{out * std::cos(around), up, out * std::sin(around)};
        beginObject(site.mesh, "fruit");
        addSphere(site.mesh, {crown.center + 0.92 * crown.radii * direction}, 0.06, 0.06, site.detail.count(6, 4),
                  site.palette.fruit);
    }
}

/// An orange tree in a stone planter.
void addTree(const Site& site, const glm::dvec2& spot, SceneRandom& random) {
    const Placement foot = turned({spot.x, 0, spot.y}, random.between(0, 1));
    const double height = random.between(1.9, 2.4);
    const double crown = random.between(0.85, 1.1);
    beginObject(site.mesh, "planter");
    addBox(site.mesh, foot, {-0.55, -0.03, -0.55}, {0.55, 0.5, 0.55}, site.palette.marble);
    addBox(site.mesh, foot, {-0.6, 0.5, -0.6}, {0.6, 0.58, 0.6}, site.palette.sandstone);
    beginObject(site.mesh, "trunk");
    addLathe(site.mesh, foot, {{0.12, 0.58}, {0.085, 0.9}, {0.075, 1.4}, {0.09, height}, {0.05, height + 0.5 * crown}},
             site.detail.count(8, 5), site.palette.trunk);
    const LeafCloud leaves{
        foot.point({0, height + 0.6 * crown, 0}), {crown, 0.85 * crown, crown}, 11.0 * crown * crown, 0.0};
    site.leafClouds.push_back(leaves);
    if (site.detail.has(0.65)) addFruit(site, leaves, random);
}

/// Ivy that hangs from the arches around the court, the denser the greater the depth.
void addIvy(const Site& site) {
    for (const Side& side : sidesOf(kCourtHalf))
        for (uint32_t bay = 0; bay < side.bays; ++bay)
            site.leafClouds.push_back({side.place.point({kBay * (bay + 0.5), 3.4, 0.0}),
                                       glm::abs(side.place.direction({1.1, 0.7, 0.35})), 6.0 * (site.rows - 2), 0.0});
}

/// The first ones are planted at any depth; the later ones fill the view of the default camera.
constexpr std::array<glm::dvec2, 16> kTreeSpots{{{-4.3, 3.1},
                                                 {4.3, -3.1},
                                                 {4.3, 3.1},
                                                 {-4.3, -3.1},
                                                 {1.0, 4.2},
                                                 {0.0, -3.9},
                                                 {-1.6, 3.2},
                                                 {-5.6, 0.2},
                                                 {5.9, 0.3},
                                                 {2.4, -4.6},
                                                 {-2.3, -4.3},
                                                 {6.2, -4.6},
                                                 {6.2, 4.5},
                                                 {2.8, 1.9},
                                                 {-6.0, -4.7},
                                                 {2.7, -1.7}}};

}  // namespace

void addTrees(const Site& site) {
    SceneRandom random = site.random(kTreePart);
    const size_t count = site.rows == 1 ? 2 : std::min<size_t>(kTreeSpots.size(), 3 * site.rows - 2);
    for (size_t i = 0; i < count; ++i) addTree(site, kTreeSpots[i], random);
    if (site.rows > 2) addIvy(site);
}

}  // namespace manylight::courtyard
