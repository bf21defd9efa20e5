// The shell of the room: floor, walls, ceiling, the window and its curtains.
#include "engine/scene/generate/showcase_parts.h"
#include "shaders/shared/constants.h"

#include <algorithm>
#include <cmath>

namespace manylight::showcase {
namespace {

constexpr glm::dvec3 kDown{0, -1, 0};
constexpr double kBack = -kHalfDepth;
constexpr double kReveal = 0.18;  // depth of the window in the wall

/// The back wall around the window, seen from the room.
void addBackWall(Solid& solid) {
    const Plane plane{{-kHalfWidth, kHeight, kBack}, {1, 0, 0}, kDown};
    const glm::dvec2 low(kWindowLow.x + kHalfWidth, kHeight - kWindowHigh.y);
    const glm::dvec2 high(kWindowHigh.x + kHalfWidth, kHeight - kWindowLow.y);
    const double width = 2 * kHalfWidth;
    addPanel(solid, {kWall}, plane, {0, 0}, {width, low.y});
    addPanel(solid, {kWall}, plane, {0, low.y}, {low.x, high.y});
    addPanel(solid, {kWall}, plane, {high.x, low.y}, {width, high.y});
    addPanel(solid, {kWall}, plane, {0, high.y}, {width, kHeight});
}

void addReveal(Solid& solid) {
    const double width = kWindowHigh.x - kWindowLow.x;
    const double height = kWindowHigh.y - kWindowLow.y;
    const double outside = kBack - kReveal;
    addPanel(solid, {kPaint}, {{kWindowLow.x, kWindowHigh.y, kBack}, {0, 0, -1}, kDown}, {0, 0}, {kReveal, height});
    addPanel(solid, {kPaint}, {{kWindowHigh.x, kWindowHigh.y, outside}, {0, 0, 1}, kDown}, {0, 0}, {kReveal, height});
    addPanel(solid, {kPaint}, {{kWindowLow.x, kWindowHigh.y, kBack}, {1, 0, 0}, {0, 0, -1}}, {0, 0}, {width, kReveal});
    addPanel(solid, {kPaint}, {{kWindowLow.x, kWindowLow.y, outside}, {1, 0, 0}, {0, 0, 1}}, {0, 0}, {width, kReveal});
}

void addWindowBars(Solid& solid) {
    constexpr double kBar = 0.05;
    const double back = kBack - 0.14;
    const double front = back + kBar;
    const double middle = 0.5 * (kWindowLow.x + kWindowHigh.x);
    for (const double x : {kWindowLow.x, middle - 0.5 * kBar, kWindowHigh.x - kBar})
        addBlock(solid, {kPaint}, {x, kWindowLow.y, back}, {x + kBar, kWindowHigh.y, front});
    // Between the upright bars, so that no face lies in another.
    for (const double y : {kWindowLow.y, kWindowLow.y + 0.95, kWindowHigh.y - kBar})
        for (const double x : {kWindowLow.x + kBar, middle + 0.5 * kBar})
            addBlock(solid, {kPaint}, {x, y, back + 0.005},
                     {x + middle - kWindowLow.x - 1.5 * kBar, y + kBar, front - 0.005});
    addRoundedBlock(solid, {kPaint}, {kWindowLow.x - 0.08, kWindowLow.y - 0.04, kBack + 0.001},
                    {kWindowHigh.x + 0.08, kWindowLow.y - 0.002, kBack + 0.12}, 0.012, 2);
}

void addCurtain(Solid& solid, double left, double right, double z) {
    constexpr double kTop = 2.46;
    constexpr double kHem = 0.3;
    addPatch(solid, {kCurtain}, {64, 4}, {right - left, kTop - kHem}, [&](double u, double v) {
        const double fold = 2.0 * double{shared::kPi} * u * 6.5;
        // Folds open towards the hem.
        return glm::dvec3(glm::mix(left, right, u) + 0.015 * std::sin(0.7 * fold), glm::mix(kTop, kHem, v),
                          z + (0.025 + 0.02 * v) * std::sin(fold + 0.8 * v));
    });
}

void addSkirting(Solid& solid) {
    constexpr double kTop = 0.1;
    constexpr double kThick = 0.018;
    const double x = kHalfWidth;
    addBlock(solid, {kPaint}, {-x + kThick, 0.001, kBack + 0.001}, {x - kThick, kTop, kBack + kThick});
    for (const double side : {-1.0, 1.0}) {
        const double wall = side * (x - 0.001);
        const double room = side * (x - kThick);
        addBlock(solid, {kPaint}, {std::min(wall, room), 0.001, kBack + 0.001},
                 {std::max(wall, room), kTop, kHalfDepth - 0.001});
    }
}

}  // namespace

void addWalls(Room& room) {
    const double width = 2 * kHalfWidth;
    const double depth = 2 * kHalfDepth;
    const double x = kHalfWidth;
    const double z = kHalfDepth;
    Solid shell;
    addPanel(shell, {kFloor}, {{-x, 0, -z}, {1, 0, 0}, {0, 0, 1}}, {0, 0}, {width, depth});
    addPanel(shell, {kCeiling}, {{-x, kHeight, z}, {1, 0, 0}, {0, 0, -1}}, {0, 0}, {width, depth});
    addPanel(shell, {kWall}, {{-x, kHeight, z}, {0, 0, -1}, kDown}, {0, 0}, {depth, kHeight});
    addPanel(shell, {kWall}, {{x, kHeight, -z}, {0, 0, 1}, kDown}, {0, 0}, {depth, kHeight});
    addPanel(shell, {kWall}, {{x, kHeight, z}, {-1, 0, 0}, kDown}, {0, 0}, {width, kHeight});
    addBackWall(shell);
    addSkirting(shell);
    room.show(shell, "shell");

    Solid rug;
    addRoundedBlock(rug, {kRug}, {-1.95, 0.001, -1.35}, {0.75, 0.014, 0.65}, 0.006, 1);
    room.show(rug, "rug");
}

void addWindow(Room& room) {
    Solid window;
    addReveal(window);
    addWindowBars(window);
    room.show(window, "window");

    Solid curtains;
    const double z = kBack + 0.19;
    addCurtain(curtains, kWindowLow.x - 0.42, kWindowLow.x + 0.3, z);
    addCurtain(curtains, kWindowHigh.x - 0.26, kWindowHigh.x + 0.3, z);
    addRod(curtains, {kBrass}, {kWindowLow.x - 0.5, 2.49, z}, {kWindowHigh.x + 0.38, 2.49, z}, 0.014);
    for (const double x : {kWindowLow.x - 0.5, kWindowHigh.x + 0.38})
        addBall(curtains, {kBrass}, {x, 2.49, z}, glm::dvec3(0.03), {12, 8});
    room.show(curtains, "curtains");
}

}  // namespace manylight::showcase
