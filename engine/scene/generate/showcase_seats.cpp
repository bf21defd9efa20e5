// The sofa under the window, two armchairs, their cushions, and the table between them.
#include "engine/scene/generate/showcase_parts.h"

namespace manylight::showcase {
namespace {

constexpr double kSeatHeight = 0.42;

void addLegs(Solid& solid, const Cover& cover, const glm::dvec3& half, double height, double radius) {
    for (const double x : {-half.x, half.x})
        for (const double z : {-half.z, half.z}) addRod(solid, cover, {x, height, z}, {x, 0.0, z}, radius);
}

/// Faces +z; its middle is at the origin.
Solid seat(double width, uint32_t places, uint32_t cells) {
    constexpr double kArm = 0.17;
    const double half = 0.5 * width;
    const double inside = half - kArm;
    Solid solid;
    addRoundedBlock(solid, {kFabric}, {-half + 0.02, 0.12, -0.4}, {half - 0.02, 0.27, 0.38}, 0.03, cells);
    addRoundedBlock(solid, {kFabric}, {-inside - 0.02, 0.24, -0.42}, {inside + 0.02, 0.84, -0.22}, 0.08, cells);
    for (const double side : {-1.0, 1.0}) {
        const double x = side * (half - 0.5 * kArm);
        addRoundedBlock(solid, {kFabric}, {x - 0.5 * kArm, 0.14, -0.41}, {x + 0.5 * kArm, 0.6, 0.4}, 0.07, cells);
    }
    const double step = 2 * inside / places;
    for (uint32_t i = 0; i < places; ++i) {
        const double left = -inside + step * i;
        addRoundedBlock(solid, {kFabric}, {left + 0.004, 0.265, -0.24}, {left + step - 0.004, kSeatHeight, 0.4}, 0.055,
                        cells);
    }
    addLegs(solid, {kBrass}, {half - 0.12, 0, 0.3}, 0.14, 0.018);
    return solid;
}

glm::dquat leaning(double yawDegrees, double backDegrees, double rollDegrees) {
    return yaw(yawDegrees) * glm::angleAxis(glm::radians(-backDegrees), glm::dvec3(1, 0, 0)) *
           glm::angleAxis(glm::radians(rollDegrees), glm::dvec3(0, 0, 1));
}

void addCushions(Room& room, const glm::dvec3& sofa, const Pose& left, const Pose& right) {
    Solid solid;
    addPillow(solid, {kCushion}, {0.22, 0.22, 0.09}, 10);
    const size_t cushion = room.addMesh(solid, "cushion");
    const double y = kSeatHeight + 0.21;
    room.show(cushion, {sofa + glm::dvec3(-0.6, y, -0.08), leaning(18, 20, 4)});
    room.show(cushion, {sofa + glm::dvec3(0.62, y, -0.09), leaning(-14, 18, 41), {0.92, 0.92, 1.0}});
    // Longer than it is high.
    room.show(cushion, {sofa + glm::dvec3(0.1, y - 0.05, -0.1), leaning(4, 16, 0), {1.45, 0.75, 0.95}});
    for (const Pose& chair : {left, right})
        room.show(cushion, {chair.origin + chair.turn * glm::dvec3(0.0, y - 0.03, -0.1),
                            chair.turn * leaning(0, 16, 0),
                            {1.0, 0.85, 0.9}});
}

Solid cup() {
    Solid solid;
    // From the middle of the bottom inside over the rim and down.
    addTurned(solid, {kGlaze}, {},
              {{0.0, 0.012},
               {0.022, 0.014},
               {0.036, 0.045},
               {0.04, 0.075},
               {0.043, 0.077},
               {0.041, 0.045},
               {0.026, 0.006},
               {0.02, 0.0}},
              {16, 11});
    addTurned(solid, {kGlaze}, {}, {{0.0, 0.004}, {0.05, 0.006}, {0.075, 0.014}, {0.076, 0.01}, {0.045, 0.0}}, {18, 6});
    return solid;
}

}  // namespace

void addSeats(Room& room) {
    const glm::dvec3 sofa(-1.1, 0.0, -1.72);
    room.show(seat(2.1, 2, 3), "sofa", {sofa});
    const size_t armchair = room.addMesh(seat(0.86, 1, 2), "armchair");
    const Pose left{{-1.98, 0.0, 0.28}, yaw(72)};
    const Pose right{{1.12, 0.0, -0.12}, yaw(-62)};
    room.show(armchair, left);
    room.show(armchair, right);
    addCushions(room, sofa, left, right);
}

void addTable(Room& room) {
    const glm::dvec3 table(-0.6, 0.014, -0.3);
    constexpr double kTop = 0.42;
    Solid solid;
    addRoundedBlock(solid, {kGlass}, {-0.58, kTop - 0.018, -0.32}, {0.58, kTop, 0.32}, 0.006, 1);
    addRoundedBlock(solid, {kWood}, {-0.5, 0.13, -0.26}, {0.5, 0.155, 0.26}, 0.008, 1);
    addLegs(solid, {kBrass}, {0.52, 0, 0.27}, kTop - 0.018, 0.016);
    room.show(solid, "table", {table});

    Solid bowl;
    addTurned(bowl, {kBrass}, {},
              {{0.0, 0.03},
               {0.08, 0.035},
               {0.14, 0.07},
               {0.165, 0.105},
               {0.17, 0.106},
               {0.15, 0.066},
               {0.085, 0.02},
               {0.07, 0.0}},
              {32, 16});
    const glm::dvec3 top = table + glm::dvec3(0.0, kTop + 0.001, 0.0);
    room.show(bowl, "bowl", {top + glm::dvec3(0.06, 0.0, -0.04)});
    Solid ball;
    addBall(ball, {kOrange}, {}, {0.045, 0.042, 0.045}, {14, 8});
    const size_t orange = room.addMesh(ball, "orange");
    for (const glm::dvec3& place : {glm::dvec3(0.0, 0.08, 0.02),
                                    {0.13, 0.085, 0.0},
                                    {0.07, 0.083, -0.12},
                                    {0.06, 0.15, -0.03},
                                    {0.08, 0.083, 0.06}})
        room.show(orange, {top + place, yaw(360.0 * room.random.unit()), glm::dvec3(room.random.between(0.92, 1.1))});
    const size_t teacup = room.addMesh(cup(), "cup");
    for (const glm::dvec2& place : {glm::dvec2(-0.38, 0.12), {0.4, 0.1}, {-0.3, -0.17}})
        room.show(teacup, {top + glm::dvec3(place.x, 0.0, place.y), yaw(360.0 * room.random.unit())});
}

}  // namespace manylight::showcase
