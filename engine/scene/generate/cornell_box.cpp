#include "engine/scene/generate/cornell_box.h"

#include <array>

namespace manylight {

namespace {

using Quad = std::array<glm::dvec3, 4>;

/// The four corners of a block's top; its sides go down to the floor.
void addBlock(Mesh& mesh, const char* name, uint32_t material, const Quad& top) {
    beginObject(mesh, name);
    std::array<uint32_t, 4> high{};
    std::array<uint32_t, 4> low{};
    for (size_t i = 0; i < 4; ++i) {
        high[i] = addPosition(mesh, top[i]);
        low[i] = addPosition(mesh, {top[i].x, 0.0, top[i].z});
    }
    addQuad(mesh, material, high[0], high[1], high[2], high[3]);
    for (size_t i = 0; i < 4; ++i) {
        const size_t next = (i + 1) % 4;
        addQuad(mesh, material, low[i], low[next], high[next], high[i]);
    }
    addQuad(mesh, material, low[3], low[2], low[1], low[0]);
}

/// The ceiling as a frame of four quads around the light.
void addCeiling(Mesh& mesh, uint32_t material, const Quad& outer, const Quad& light) {
    beginObject(mesh, "ceiling", false);
    std::array<uint32_t, 4> rim{};
    std::array<uint32_t, 4> hole{};
    for (size_t i = 0; i < 4; ++i) {
        rim[i] = addPosition(mesh, outer[i]);
        hole[i] = addPosition(mesh, light[i]);
    }
    for (size_t i = 0; i < 4; ++i) {
        const size_t next = (i + 1) % 4;
        addQuad(mesh, material, rim[i], rim[next], hole[next], hole[i]);
    }
}

void addWall(Mesh& mesh, const char* name, uint32_t material, const Quad& corners) {
    beginObject(mesh, name, false);
    addQuad(mesh, material, corners);
}

constexpr double kHeight = 548.8;
constexpr Quad kLight{{{343, kHeight, 227}, {343, kHeight, 332}, {213, kHeight, 332}, {213, kHeight, 227}}};
constexpr Quad kCeiling{{{556, kHeight, 0}, {556, kHeight, 559.2}, {0, kHeight, 559.2}, {0, kHeight, 0}}};
constexpr Quad kFloor{{{552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2}}};
constexpr Quad kBackWall{{{549.6, 0, 559.2}, {0, 0, 559.2}, {0, kHeight, 559.2}, {556, kHeight, 559.2}}};
constexpr Quad kRightWall{{{0, 0, 559.2}, {0, 0, 0}, {0, kHeight, 0}, {0, kHeight, 559.2}}};
constexpr Quad kLeftWall{{{552.8, 0, 0}, {549.6, 0, 559.2}, {556, kHeight, 559.2}, {556, kHeight, 0}}};
constexpr Quad kShortBlockTop{{{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}}};
constexpr Quad kTallBlockTop{{{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}}};

}  // namespace

GeneratedScene generateCornellBox() {
    GeneratedScene scene;
    scene.name = "cornell_box";
    scene.comments = {
        "The Cornell box, in millimetres.", "Geometry and camera: Cornell University Program of Computer Graphics,",
        "https://www.graphics.cornell.edu/online/box/data.html",
        "RGB reflectances and emission: \"CornellBox-Original\", McGuire Computer Graphics Archive, 2011.",
        "The ceiling is cut around the light, which lies in its plane."};

    Mesh& mesh = scene.mesh;
    const uint32_t white = addMaterial(mesh, "white", {0.725, 0.71, 0.68});
    const uint32_t red = addMaterial(mesh, "red", {0.63, 0.065, 0.05});
    const uint32_t green = addMaterial(mesh, "green", {0.14, 0.45, 0.091});
    const uint32_t light = addMaterial(mesh, "light", {0.78, 0.78, 0.78}, {17.0, 12.0, 4.0});

    addWall(mesh, "floor", white, kFloor);
    addCeiling(mesh, white, kCeiling, kLight);
    addWall(mesh, "light", light, kLight);
    addWall(mesh, "back_wall", white, kBackWall);
    addWall(mesh, "right_wall", green, kRightWall);
    addWall(mesh, "left_wall", red, kLeftWall);
    addBlock(mesh, "short_block", white, kShortBlockTop);
    addBlock(mesh, "tall_block", white, kTallBlockTop);

    // A focal length of 0.035 and a square film of 0.025: 2 atan(0.0125 / 0.035).
    scene.sidecar["camera"] = {{"origin", {278, 273, -800}},
                               {"target", {278, 273, 0}},
                               {"up", {0, 1, 0}},
                               {"fov_y_deg", 39.307755},
                               {"width", 512},
                               {"height", 512}};
    scene.sidecar["lights"] = Json::array();
    scene.sidecar["max_depth"] = -1;
    return scene;
}

}  // namespace manylight
