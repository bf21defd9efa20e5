// The bookshelf with its books and screen, the painting, the plant and the lamps.
#include "engine/scene/generate/showcase_parts.h"
#include "shaders/shared/constants.h"

#include <algorithm>
#include <cmath>

namespace manylight::showcase {
namespace {

constexpr glm::dvec3 kShelf{1.3, 0.0, -2.21};  // the middle of its foot
constexpr double kShelfHalfWidth = 0.72;
constexpr double kShelfHalfDepth = 0.17;
constexpr double kBoard = 0.025;
constexpr uint32_t kRows = 4;
constexpr double kRowHeight = 0.36;
constexpr double kFirstRow = 0.12;  // the lowest board's top

Solid shelf() {
    Solid solid;
    const double x = kShelfHalfWidth;
    const double z = kShelfHalfDepth;
    const double top = kFirstRow + kRows * kRowHeight;
    for (const double side : {-1.0, 1.0}) {
        const double outer = side * (x + kBoard);
        addBlock(solid, {kWood}, {std::min(side * x, outer), 0.001, -z}, {std::max(side * x, outer), top, z});
    }
    addBlock(solid, {kWood}, {-x, 0.05, -z}, {x, top - kBoard, -z + 0.01});
    for (uint32_t i = 0; i <= kRows; ++i) {
        const double y = kFirstRow + i * kRowHeight;
        addBlock(solid, {kWood}, {-x + 0.0005, y - kBoard, -z + 0.0105}, {x - 0.0005, y, z - 0.002});
    }
    return solid;
}

/// Upright, its spine towards +z, one unit thick, high and deep.
Solid book(const glm::dvec3& colour) {
    const glm::dvec3 paper(0.72, 0.68, 0.56);
    Solid solid;
    addBlock(solid, {kBook, colour}, {-0.5, 0.0, -0.5}, {-0.42, 1.0, 0.44});
    addBlock(solid, {kBook, colour}, {0.42, 0.0, -0.5}, {0.5, 1.0, 0.44});
    addBlock(solid, {kBook, 0.85 * colour}, {-0.5, 0.0, 0.44}, {0.5, 1.0, 0.5});
    addBlock(solid, {kBook, paper}, {-0.42, 0.02, -0.46}, {0.42, 0.98, 0.44});
    return solid;
}

void addBooks(Room& room) {
    std::vector<size_t> kinds;
    for (const glm::dvec3& colour : {glm::dvec3(0.4, 0.06, 0.05),
                                     {0.05, 0.14, 0.3},
                                     {0.45, 0.3, 0.08},
                                     {0.06, 0.22, 0.14},
                                     {0.5, 0.46, 0.38},
                                     {0.2, 0.07, 0.18}})
        kinds.push_back(room.addMesh(book(colour), "book"));
    constexpr double kGap = 0.002;
    for (uint32_t row = 0; row < kRows; ++row) {
        const double y = kFirstRow + row * kRowHeight + 0.001;
        // Two rows leave room for other things.
        double x = row == 2 ? -0.12 : -kShelfHalfWidth + 0.01;
        const double end = row == 1 ? 0.2 : kShelfHalfWidth - 0.12;
        while (true) {
            const glm::dvec3 size(room.random.between(0.025, 0.055), room.random.between(0.2, 0.29),
                                  room.random.between(0.17, 0.22));
            const size_t kind = kinds[room.random.below(static_cast<uint32_t>(kinds.size()))];
            if (x + size.x > end) break;
            const double z = 0.12 - 0.5 * size.z + room.random.between(-0.01, 0.01);
            room.show(kind, {kShelf + glm::dvec3(x + 0.5 * size.x, y, z), {1, 0, 0, 0}, size});
            x += size.x + kGap;
        }
        // The last one leans against the others.
        const glm::dquat lean = glm::angleAxis(glm::radians(13.0), glm::dvec3(0, 0, 1));
        room.show(kinds[row], {kShelf + glm::dvec3(x + 0.087, y + 0.004, 0.02), lean, {0.035, 0.24, 0.18}});
    }
}

Solid vase() {
    Solid solid;
    addTurned(solid, {kGlaze}, {},
              {{0.03, 0.19},
               {0.032, 0.23},
               {0.045, 0.25},
               {0.05, 0.248},
               {0.04, 0.22},
               {0.05, 0.18},
               {0.095, 0.11},
               {0.085, 0.04},
               {0.05, 0.0}},
              {22, 14});
    return solid;
}

/// Stands or hangs with a frame around it.
Solid framed(uint32_t picture, uint32_t frame, const glm::dvec2& half, double border) {
    const glm::dvec2 outer = half + border;
    Solid solid;
    addPanel(solid, {picture}, {{-half.x, half.y, 0.012}, {1, 0, 0}, {0, -1, 0}}, {0, 0}, 2.0 * half);
    addBlock(solid, {frame}, {-outer.x, half.y, 0.0}, {outer.x, outer.y, 0.03});
    addBlock(solid, {frame}, {-outer.x, -outer.y, 0.0}, {outer.x, -half.y, 0.03});
    addBlock(solid, {frame}, {-outer.x, -half.y, 0.0}, {-half.x, half.y, 0.03});
    addBlock(solid, {frame}, {half.x, -half.y, 0.0}, {outer.x, half.y, 0.03});
    addPanel(solid, {frame}, {{half.x, half.y, 0.001}, {-1, 0, 0}, {0, -1, 0}}, {0, 0}, 2.0 * half);
    return solid;
}

/// A blade that grows from the origin along +z, arching down; the tip of its picture is at its far end.
Solid leafBlade() {
    Solid solid;
    addPatch(solid, {kLeaf}, {2, 6}, {1.0, 1.0}, [](double u, double v) {
        const double along = 1.0 - v;
        const double across = u - 0.5;
        return glm::dvec3(0.42 * across, 0.28 * along - 0.42 * along * along + 0.22 * across * across, along);
    });
    return solid;
}

}  // namespace

void addBookshelf(Room& room) {
    room.show(shelf(), "shelf", {kShelf});
    addBooks(room);
    const auto onRow = [](uint32_t row, double x, double z) {
        return kShelf + glm::dvec3(x, kFirstRow + row * kRowHeight + 0.001, z);
    };
    const size_t vases = room.addMesh(vase(), "vase");
    room.show(vases, {onRow(1, 0.5, 0.02)});
    room.show(vases, {onRow(4, -0.5, 0.0), yaw(30), {1.1, 1.35, 1.1}});
    room.show(vases, {onRow(4, -0.28, 0.04), yaw(80), {0.8, 0.7, 0.8}});
    const glm::dquat back = glm::angleAxis(glm::radians(-9.0), glm::dvec3(1, 0, 0));
    room.show(framed(kScreen, kPaint, {0.2, 0.13}, 0.014), "screen",
              {onRow(2, -0.44, 0.04) + glm::dvec3(0, 0.147, 0), back});
    room.show(framed(kPaintingOnWall, kWood, {0.42, 0.29}, 0.035), "painting",
              {kPainting + glm::dvec3(0.0, 0.0, 0.002)});
}

void addPlant(Room& room) {
    const glm::dvec3 foot(2.15, 0.0, -0.95);
    Solid pot;
    addTurned(
        pot, {kGlaze}, {},
        {{0.0, 0.3}, {0.14, 0.3}, {0.175, 0.32}, {0.185, 0.36}, {0.2, 0.36}, {0.19, 0.28}, {0.15, 0.1}, {0.13, 0.0}},
        {32, 16});
    room.show(pot, "pot", {foot});
    const size_t blade = room.addMesh(leafBlade(), "leaf");
    constexpr uint32_t kLeaves = 40;
    Solid stems;
    for (uint32_t i = 0; i < kLeaves; ++i) {
        const double height = 0.36 + 0.75 * std::sqrt(static_cast<double>(i) / kLeaves);
        const double around = 137.5 * i + room.random.between(-15.0, 15.0);
        const double rise = -10.0 - 60.0 * i / kLeaves;
        const double size = room.random.between(0.3, 0.42) * (1.15 - 0.4 * i / kLeaves);
        const glm::dquat turn = yaw(around) * glm::angleAxis(glm::radians(rise), glm::dvec3(1, 0, 0));
        const glm::dvec3 base = yaw(around) * glm::dvec3(0.0, 0.0, 0.05);
        room.show(blade, {foot + base + glm::dvec3(0.0, height, 0.0), turn, {1.1 * size, size, size}});
        if (i % 4 == 0)
            addRod(stems, {kBook, {0.1, 0.16, 0.05}}, base + glm::dvec3(0, height, 0),
                   0.4 * base + glm::dvec3(0, 0.29, 0), 0.008);
    }
    room.show(stems, "stems", {foot});
}

void addLamps(Room& room) {
    Solid lamp;
    addTurned(lamp, {kBrass}, {}, {{0.0, 0.05}, {0.015, 0.045}, {0.06, 0.03}, {0.14, 0.02}, {0.145, 0.0}}, {28, 10});
    addRod(lamp, {kBrass}, {0, kShadeHeight - 0.1, 0}, {0, 0.04, 0}, 0.011);
    addPatch(lamp, {kShade}, {32, 4}, {1.4, 0.3}, [](double u, double v) {
        const double angle = 2.0 * double{shared::kPi} * u;
        const double radius = glm::mix(0.16, 0.23, v);
        return glm::dvec3(radius * std::sin(angle), kShadeHeight + 0.15 - 0.3 * v, radius * std::cos(angle));
    });
    room.show(lamp, "floor lamp", {kFloorLamp});

    Solid paper;
    addBall(paper, {kLantern}, {}, {0.22, 0.2, 0.22}, {24, 16});
    const size_t lantern = room.addMesh(paper, "lantern");
    room.show(lantern, {{-0.75, 2.02, -0.25}});
    room.show(lantern, {{-0.28, 2.26, -0.62}, yaw(40), {0.72, 0.95, 0.72}});
    Solid cords;
    addRod(cords, {kPaint}, {-0.75, kHeight, -0.25}, {-0.75, 2.21, -0.25}, 0.006);
    addRod(cords, {kPaint}, {-0.28, kHeight, -0.62}, {-0.28, 2.44, -0.62}, 0.006);
    // Above the spot light, out of its cone.
    addRod(cords, {kBrass}, kSpot + glm::dvec3(0.0, 0.14, 0.0), kSpot + glm::dvec3(0.0, 0.02, 0.0), 0.045);
    addBall(cords, {kBulb}, kSpot + glm::dvec3(0.0, 0.03, 0.0), glm::dvec3(0.02), {10, 6});
    room.show(cords, "cords and spot");
}

}  // namespace manylight::showcase
