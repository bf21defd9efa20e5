// The window cut into rectangles, so that panels are put over the picture only where there are panels.
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace manylight {

/// Pixels from `low` up to but not `high`.
struct PixelRect {
    glm::ivec2 low{0};
    glm::ivec2 high{0};
    bool isEmpty() const { return high.x <= low.x || high.y <= low.y; }
};

struct WindowTile {
    PixelRect rect;
    bool hasPanels = false;
};

/// Tiles that cover every pixel of `canvas` once, in columns between the sides of `panels`, which may overlap and
/// reach beyond the canvas. Every pixel of a panel is in a tile that has panels.
std::vector<WindowTile> tileWindow(glm::uvec2 canvas, std::span<const PixelRect> panels);

}  // namespace manylight
