#include "apps/view_model/window_tiles.h"

#include <algorithm>
#include <set>

namespace manylight {
namespace {

PixelRect inside(const PixelRect& rect, glm::ivec2 canvas) {
    return {glm::clamp(rect.low, glm::ivec2(0), canvas), glm::clamp(rect.high, glm::ivec2(0), canvas)};
}

}  // namespace

std::vector<WindowTile> tileWindow(glm::uvec2 canvas, std::span<const PixelRect> panels) {
    const auto size = glm::ivec2(canvas);
    std::vector<PixelRect> visible;
    std::set<int> sides = {0, size.x};
    for (const PixelRect& panel : panels) {
        const PixelRect rect = inside(panel, size);
        if (rect.isEmpty()) continue;
        visible.push_back(rect);
        sides.insert({rect.low.x, rect.high.x});
    }
    std::vector<WindowTile> tiles;
    const auto add = [&tiles](const PixelRect& rect, bool hasPanels) {
        if (!rect.isEmpty()) tiles.push_back({rect, hasPanels});
    };
    for (auto left = sides.begin(); std::next(left) != sides.end(); ++left) {
        const int right = *std::next(left);
        // Where the panels of this column begin and end.
        int top = size.y;
        int bottom = 0;
        for (const PixelRect& rect : visible) {
            if (rect.low.x > *left || rect.high.x < right) continue;
            top = std::min(top, rect.low.y);
            bottom = std::max(bottom, rect.high.y);
        }
        bottom = std::max(bottom, top);
        add({{*left, 0}, {right, top}}, false);
        add({{*left, top}, {right, bottom}}, true);
        add({{*left, bottom}, {right, size.y}}, false);
    }
    return tiles;
}

}  // namespace manylight
